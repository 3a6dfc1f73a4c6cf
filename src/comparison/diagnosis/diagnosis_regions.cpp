#include "comparison/diagnosis/diagnosis_regions.hpp"

#include <cmath>
#include <numeric>

namespace trace {
namespace {

constexpr std::size_t least_pixels = 9;
// Levels by which an outline must stand out to count as an edge: shading and rounding stay below.
constexpr int faint_edge = 8;

class Labels {
 public:
  explicit Labels(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

// The kind of an edge that is so high in the reference and in the test picture: of one kind when it is at
// least three times as high there as in the other.
void count(EdgeCounts& counts, int in_reference, int in_test) {
  if (std::max(in_reference, in_test) <= faint_edge) {
    ++counts.soft;
  } else if (in_reference > 3 * in_test) {
    ++counts.vanished;
  } else if (in_test > 3 * in_reference) {
    ++counts.appeared;
  } else {
    ++counts.kept;
  }
}

// The regions of a pair, by the cells of a coarse grid.
class Cells {
 public:
  explicit Cells(const PicturePair& pair)
      : width_(pair.width),
        columns_((pair.width + edge - 1) / edge),
        rows_((pair.height + edge - 1) / edge),
        labels_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
    std::vector<std::uint8_t> taken(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (const std::uint32_t i : pair.differing) taken[of(i)] = 1;
    for (int y = 0; y < rows_; ++y)
      for (int x = 0; x < columns_; ++x) {
        const std::uint32_t here = at(x, y);
        if (!taken[here]) continue;
        // The half of the neighbourhood that was passed.
        for (const auto& [u, v] : {std::pair{x - 1, y}, {x - 1, y - 1}, {x, y - 1}, {x + 1, y - 1}})
          if (u >= 0 && v >= 0 && u < columns_ && taken[at(u, v)]) labels_.join(here, at(u, v));
      }
  }

  std::size_t size() const { return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_); }
  // The same number for all pixels of a region.
  std::uint32_t label(std::uint32_t pixel) { return labels_.root(of(pixel)); }

 private:
  static constexpr int edge = 4;

  std::uint32_t at(int x, int y) const { return static_cast<std::uint32_t>(y * columns_ + x); }
  std::uint32_t of(std::uint32_t pixel) const {
    const int i = static_cast<int>(pixel);
    return at(i % width_ / edge, i / width_ / edge);
  }

  int width_, columns_, rows_;
  Labels labels_;
};

}  // namespace

std::vector<DifferingRegion> differing_regions(const PicturePair& pair) {
  const int width = pair.width, height = pair.height;
  Cells cells(pair);
  constexpr std::uint32_t none = 0xffffffff;
  std::vector<std::uint32_t> number(cells.size(), none);
  std::vector<DifferingRegion> regions;
  for (const std::uint32_t i : pair.differing) {
    const std::uint32_t label = cells.label(i);
    const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
    if (number[label] == none) {
      number[label] = static_cast<std::uint32_t>(regions.size());
      regions.push_back({{x, y, x + 1, y + 1, 0, 0}, 0, {}, {}});
    }
    DifferingRegion& region = regions[number[label]];
    Region& box = region.box;
    box.x0 = std::min(box.x0, x);
    box.x1 = std::max(box.x1, x + 1);
    box.y1 = std::max(box.y1, y + 1);
    ++box.pixels;
    for (std::size_t c = 0; c < 3; ++c) {
      const int d = pair.of_test(i)[c] - pair.of_reference(i)[c];
      region.energy += d * d;
    }
    static constexpr int steps[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (int k = 0; k < 4; ++k) {
      const int u = x + steps[k][0], v = y + steps[k][1];
      if (u < 0 || v < 0 || u >= width || v >= height) continue;
      const std::size_t there = pair.index(u, v);
      const int in_reference = distance(pair.of_reference(i), pair.of_reference(there));
      const int in_test = distance(pair.of_test(i), pair.of_test(there));
      if (!pair.differs[there]) {
        count(region.outline, in_reference, in_test);
      } else if (k < 2 && std::max(in_reference, in_test) > faint_edge) {
        count(region.inside, in_reference, in_test);
      }
    }
  }
  std::erase_if(regions, [](const DifferingRegion& region) { return region.box.pixels < least_pixels; });
  for (DifferingRegion& region : regions) {
    const double samples = 3.0 * (region.box.x1 - region.box.x0) * (region.box.y1 - region.box.y0);
    region.box.root_mean_square = std::sqrt(region.energy / samples);
  }
  std::stable_sort(regions.begin(), regions.end(),
                   [](const DifferingRegion& a, const DifferingRegion& b) { return a.energy > b.energy; });
  return regions;
}

}  // namespace trace
