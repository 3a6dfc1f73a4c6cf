#include "comparison/diagnosis/diagnosis_edges.hpp"

#include <array>

namespace trace {
namespace {

// The thresholds are set from the measurements in docs/results/diagnosis.md: antialiased pictures and
// pictures sampled half a pixel away have up to 9 % outside (lines thinner than a pixel, corners); no other
// defect that was tried has less than 20 % in most parts of the picture.
constexpr double most_outside = 0.09;
// Small pictures have many pixels beside two edges: highlights, and details of a mesh.
constexpr double most_thick = 0.6;
// Resampling brightens as it darkens.
constexpr double least_either_way = 0.2;
// The picture is cut into 8 x 8 parts; of those with edges, what must hold a difference.
constexpr int parts = 8;
constexpr double least_parts = 0.6;
constexpr std::size_t sample = 4096;  // pixels, chosen evenly, that the shares are estimated from
constexpr int edge_height = 16;       // levels, of an edge that another sample position is bound to show
// Levels. What differs by less is shading a part of a pixel further on.
constexpr int negligible = 4;
constexpr int rounding = 2;  // levels, of the colours around a pixel

struct Surroundings {
  std::array<int, 3> low{255, 255, 255}, high{0, 0, 0};

  int height() const { return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]}); }
  bool contain(const std::uint8_t* color) const {
    for (std::size_t c = 0; c < 3; ++c)
      if (color[c] < low[c] - rounding || color[c] > high[c] + rounding) return false;
    return true;
  }
};

// Of the 3x3 pixels, cut at the border.
Surroundings around(const Image& image, int x, int y) {
  Surroundings box;
  for (int v = std::max(0, y - 1); v <= std::min(image.height - 1, y + 1); ++v)
    for (int u = std::max(0, x - 1); u <= std::min(image.width - 1, x + 1); ++u) {
      const std::uint8_t* color =
          &image.rgb[(static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width) +
                      static_cast<std::size_t>(u)) *
                     3];
      for (std::size_t c = 0; c < 3; ++c) {
        box.low[c] = std::min<int>(box.low[c], color[c]);
        box.high[c] = std::max<int>(box.high[c], color[c]);
      }
    }
  return box;
}

bool thick(const PicturePair& pair, int x, int y) {
  for (int v = std::max(0, y - 1); v <= std::min(pair.height - 1, y + 1); ++v)
    for (int u = std::max(0, x - 1); u <= std::min(pair.width - 1, x + 1); ++u)
      if (const std::size_t i = pair.index(u, v);
          distance(pair.of_reference(i), pair.of_test(i)) <= negligible)
        return false;
  return true;
}

int sum(const std::uint8_t* color) {
  return color[0] + color[1] + color[2];
}

// Share of the parts of the picture with an edge that differ somewhere.
double parts_touched(const PicturePair& pair) {
  std::array<int, parts * parts> edges{}, differing{};
  for (int y = 1; y < pair.height; ++y)
    for (int x = 1; x < pair.width; ++x) {
      const std::size_t i = pair.index(x, y);
      const auto part = static_cast<std::size_t>(y * parts / pair.height * parts + x * parts / pair.width);
      differing[part] += pair.differs[i] && distance(pair.of_reference(i), pair.of_test(i)) > negligible;
      const std::uint8_t* here = pair.of_reference(i);
      edges[part] += distance(here, here - 3) > edge_height ||
                     distance(here, pair.of_reference(pair.index(x, y - 1))) > edge_height;
    }
  int with_edges = 0, touched = 0;
  for (std::size_t part = 0; part < edges.size(); ++part) {
    if (edges[part] < 8) continue;
    ++with_edges;
    touched += differing[part] > 0;
  }
  return with_edges == 0 ? 0 : static_cast<double>(touched) / with_edges;
}

}  // namespace

EdgeSigns edge_signs(const PicturePair& pair) {
  EdgeSigns signs;
  std::vector<std::uint32_t> substantial;
  for (const std::uint32_t i : pair.differing)
    if (distance(pair.of_reference(i), pair.of_test(i)) > negligible) substantial.push_back(i);
  signs.pixels = substantial.size();
  if (substantial.empty()) return signs;
  const std::size_t step = (substantial.size() + sample - 1) / sample;
  std::size_t tried = 0, outside = 0, outside_other = 0, thick_ones = 0, brighter = 0;
  for (std::size_t k = 0; k < substantial.size(); k += step) {
    const std::size_t i = substantial[k];
    const int x = static_cast<int>(i % static_cast<std::size_t>(pair.width));
    const int y = static_cast<int>(i / static_cast<std::size_t>(pair.width));
    ++tried;
    thick_ones += thick(pair, x, y);
    brighter += sum(pair.of_test(i)) > sum(pair.of_reference(i));
    const Surroundings in_reference = around(pair.reference, x, y);
    outside += !in_reference.contain(pair.of_test(i));
    // A smooth reference still has its edge there; without one, it is the test picture that is rough.
    outside_other +=
        in_reference.height() <= 2 * negligible || !around(pair.test, x, y).contain(pair.of_reference(i));
  }
  const auto share = [&](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(tried);
  };
  signs.outside = share(std::min(outside, outside_other));
  signs.brighter = share(brighter);
  signs.thick = share(thick_ones);
  signs.parts = parts_touched(pair);
  return signs;
}

std::optional<Finding> find_edges(const PicturePair& pair) {
  const EdgeSigns signs = edge_signs(pair);
  if (signs.pixels < least_pixels_to_judge || signs.outside > most_outside || signs.thick > most_thick ||
      signs.parts < least_parts || signs.brighter < least_either_way || signs.brighter > 1 - least_either_way)
    return std::nullopt;
  return Finding{{Diagnosis::Kind::edges, "differs along edges only: antialiasing or sampling position"},
                 signs.outside};
}

}  // namespace trace
