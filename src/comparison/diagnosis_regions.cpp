#include "comparison/diagnosis_regions.hpp"

#include <cmath>
#include <numeric>

namespace trace {
namespace {

constexpr std::size_t least_pixels = 9;
// Levels by which an outline must stand out to count as an edge: shading and rounding stay below.
constexpr int edge_height = 8;

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
  if (std::max(in_reference, in_test) <= edge_height) {
    ++counts.soft;
  } else if (in_reference > 3 * in_test) {
    ++counts.vanished;
  } else if (in_test > 3 * in_reference) {
    ++counts.appeared;
  } else {
    ++counts.kept;
  }
}

}  // namespace

std::vector<DifferingRegion> differing_regions(const PicturePair& pair, int gap) {
  const int width = pair.width, height = pair.height;
  Labels labels(pair.differs.size());
  for (const std::uint32_t i : pair.differing) {
    const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
    // The half of the neighbourhood that was passed.
    for (int v = std::max(0, y - 1 - gap); v <= y; ++v)
      for (int u = std::max(0, x - 1 - gap); u <= (v == y ? x - 1 : std::min(width - 1, x + 1 + gap)); ++u)
        if (pair.differs[pair.index(u, v)]) labels.join(i, static_cast<std::uint32_t>(pair.index(u, v)));
  }

  std::vector<std::uint32_t> number(pair.differs.size());
  std::vector<DifferingRegion> regions;
  for (const std::uint32_t i : pair.differing) {
    const std::uint32_t root = labels.root(i);
    const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
    if (root == i) {
      number[i] = static_cast<std::uint32_t>(regions.size());
      regions.push_back({{x, y, x + 1, y + 1, 0, 0}, 0, {}, {}});
    }
    DifferingRegion& region = regions[number[root]];
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
      } else if (k < 2 && std::max(in_reference, in_test) > edge_height) {
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
