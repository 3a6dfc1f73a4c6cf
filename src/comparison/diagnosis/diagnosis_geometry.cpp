#include "comparison/diagnosis/diagnosis_geometry.hpp"

#include <fmt/format.h>

#include <array>

namespace trace {
namespace {

constexpr double most_left_over = 0.02;  // see the header
constexpr int largest_shift = 4;
constexpr std::size_t tried_first = 2048;  // pixels that a mapping is tried on before it is looked at in full

// test(x, y) is the reference at the mapped place: mirrored, then moved by (dx, dy).
struct Mapping {
  bool mirror_x = false, mirror_y = false;
  int dx = 0, dy = 0;  // where the content went, right and down
  std::array<int, 3> channels{0, 1, 2};

  // The place in the reference; it may lie outside.
  int x(int at, int width) const { return (mirror_x ? width - 1 - at : at) - (mirror_x ? -dx : dx); }
  int y(int at, int height) const { return (mirror_y ? height - 1 - at : at) - (mirror_y ? -dy : dy); }
};

int off_by(const Mapping& mapping, const std::uint8_t* reference, const std::uint8_t* test) {
  int largest = 0;
  for (std::size_t c = 0; c < 3; ++c)
    largest = std::max(largest, std::abs(test[c] - reference[mapping.channels[c]]));
  return largest;
}

// Whether the mapping holds for nearly all of an even choice of the pixels that differ. Stops early.
bool promising(const PicturePair& pair, const Mapping& mapping) {
  const std::size_t step = std::max<std::size_t>(1, pair.differing.size() / tried_first);
  const std::size_t tried = pair.differing.size() / step;
  // Twice the share that is accepted in full, as a choice of the pixels has its own scatter.
  const auto allowed = static_cast<std::size_t>(2 * most_left_over * static_cast<double>(tried)) + 1;
  std::size_t off = 0, inside = 0;
  for (std::size_t k = 0; k < pair.differing.size(); k += step) {
    const std::size_t i = pair.differing[k];
    const int x = mapping.x(static_cast<int>(i % static_cast<std::size_t>(pair.width)), pair.width);
    const int y = mapping.y(static_cast<int>(i / static_cast<std::size_t>(pair.width)), pair.height);
    if (x < 0 || y < 0 || x >= pair.width || y >= pair.height) continue;
    ++inside;
    if (off_by(mapping, pair.of_reference(pair.index(x, y)), pair.of_test(i)) > 1 && ++off > allowed)
      return false;
  }
  return inside * 2 > tried;
}

struct Residual {
  double pixels = 0, energy = 0;  // what is left, as shares of what there was
};

Residual residual(const PicturePair& pair, const Mapping& mapping) {
  double before = 0, after = 0;
  std::size_t off_before = 0, off_after = 0;
  for (int y = 0; y < pair.height; ++y) {
    const int from_y = mapping.y(y, pair.height);
    if (from_y < 0 || from_y >= pair.height) continue;
    for (int x = 0; x < pair.width; ++x) {
      const int from_x = mapping.x(x, pair.width);
      if (from_x < 0 || from_x >= pair.width) continue;
      const std::size_t i = pair.index(x, y);
      const std::uint8_t* reference = pair.of_reference(i);
      const std::uint8_t* test = pair.of_test(i);
      const std::uint8_t* mapped = pair.of_reference(pair.index(from_x, from_y));
      for (std::size_t c = 0; c < 3; ++c) {
        const int was = test[c] - reference[c], is = test[c] - mapped[mapping.channels[c]];
        before += was * was;
        after += is * is;
      }
      off_before += pair.differs[i];
      off_after += off_by(mapping, mapped, test) > 1;
    }
  }
  if (off_before < least_pixels_to_judge) return {1, 1};
  return {static_cast<double>(off_after) / static_cast<double>(off_before), after / before};
}

struct BestMapping {
  Mapping mapping;
  double unexplained;
};

// The first of the best.
template <class Mappings>
std::optional<BestMapping> best(const PicturePair& pair, const Mappings& mappings) {
  std::optional<BestMapping> found;
  for (const Mapping& mapping : mappings) {
    if (!promising(pair, mapping)) continue;
    const Residual left = residual(pair, mapping);
    if (left.pixels > most_left_over || left.energy > most_left_over) continue;
    const double unexplained = std::max(left.pixels, left.energy);
    if (!found || unexplained < found->unexplained) found = BestMapping{mapping, unexplained};
  }
  return found;
}

std::string pixels(int count, const char* where) {
  return fmt::format("{} pixel{} {}", count, count == 1 ? "" : "s", where);
}

// "shifted by 1 pixel to the right and 2 pixels up"
std::string shift_text(const Mapping& mapping) {
  std::string text = "shifted by ";
  if (mapping.dx != 0) text += pixels(std::abs(mapping.dx), mapping.dx > 0 ? "to the right" : "to the left");
  if (mapping.dx != 0 && mapping.dy != 0) text += " and ";
  if (mapping.dy != 0) text += pixels(std::abs(mapping.dy), mapping.dy > 0 ? "down" : "up");
  return text;
}

// Flips with a shift whose longer part is `reach`.
std::optional<Finding> find_mirrored(const PicturePair& pair, int reach) {
  std::vector<Mapping> mappings;
  for (const auto& [mirror_x, mirror_y] : {std::pair{true, false}, {false, true}, {true, true}})
    for (int dy = -reach; dy <= reach; ++dy)
      for (int dx = -reach; dx <= reach; ++dx)
        if (std::max(std::abs(dx), std::abs(dy)) == reach)
          mappings.push_back({mirror_x, mirror_y, dx, dy, {0, 1, 2}});
  const auto fit = best(pair, mappings);
  if (!fit) return std::nullopt;
  const Mapping& mapping = fit->mapping;
  std::string text = mapping.mirror_x && mapping.mirror_y ? "rotated by 180 degrees"
                     : mapping.mirror_x                   ? "flipped left-right"
                                                          : "flipped upside down";
  if (reach != 0) text += ", and " + shift_text(mapping);
  return Finding{{Diagnosis::Kind::flipped, text}, fit->unexplained};
}

}  // namespace

std::optional<Finding> find_channel_order(const PicturePair& pair) {
  struct Order {
    std::array<int, 3> channels;
    const char* text;
  };
  static constexpr Order orders[] = {
      {{2, 1, 0}, "red and blue are swapped"},
      {{1, 0, 2}, "red and green are swapped"},
      {{0, 2, 1}, "green and blue are swapped"},
      {{1, 2, 0}, "the colour channels are in the order green, blue, red"},
      {{2, 0, 1}, "the colour channels are in the order blue, red, green"},
  };
  std::optional<Finding> found;
  for (const Order& order : orders) {
    const Mapping mapping{false, false, 0, 0, order.channels};
    const auto fit = best(pair, std::array{mapping});
    if (fit && (!found || fit->unexplained < found->unexplained))
      found = Finding{{Diagnosis::Kind::channels_swapped, order.text}, fit->unexplained};
  }
  return found;
}

std::optional<Finding> find_flip(const PicturePair& pair) {
  return find_mirrored(pair, 0);
}

std::optional<Finding> find_mirrored_axis(const PicturePair& pair) {
  return find_mirrored(pair, 1);
}

std::optional<Finding> find_shift(const PicturePair& pair) {
  std::vector<Mapping> mappings;
  for (int dy = -largest_shift; dy <= largest_shift; ++dy)
    for (int dx = -largest_shift; dx <= largest_shift; ++dx)
      if (dx != 0 || dy != 0) mappings.push_back({false, false, dx, dy, {0, 1, 2}});
  // Short ones first: of equals, as on a checkerboard, the shortest counts.
  std::stable_sort(mappings.begin(), mappings.end(), [](const Mapping& a, const Mapping& b) {
    return std::abs(a.dx) + std::abs(a.dy) < std::abs(b.dx) + std::abs(b.dy);
  });
  const auto fit = best(pair, mappings);
  if (!fit) return std::nullopt;
  return Finding{{Diagnosis::Kind::shifted, shift_text(fit->mapping)}, fit->unexplained};
}

}  // namespace trace
