#include "comparison/worst_regions.hpp"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

constexpr int cell_side = 4;  // pixels

struct Cell {
  Region region;      // its pixels' box and count
  double square = 0;  // sum of the pixels' squared differences
};

void join(Cell& whole, const Cell& part) {
  Region& box = whole.region;
  const bool first = box.pixels == 0;
  box.x0 = first ? part.region.x0 : std::min(box.x0, part.region.x0);
  box.y0 = first ? part.region.y0 : std::min(box.y0, part.region.y0);
  box.x1 = std::max(box.x1, part.region.x1);
  box.y1 = std::max(box.y1, part.region.y1);
  box.pixels += part.region.pixels;
  whole.square += part.square;
}

class Grid {
 public:
  Grid(int width, int height, const std::vector<float>& levels)
      : columns_((width + cell_side - 1) / cell_side),
        rows_((height + cell_side - 1) / cell_side),
        cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
    const float* level = levels.data();
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x, ++level) {
        if (!over(*level, 1)) continue;
        const double size = static_cast<double>(*level);
        join(cell(x / cell_side, y / cell_side), {{x, y, x + 1, y + 1, 1, 0}, size * size});
      }
  }

  // The regions in order of their topmost cells; the cells are empty afterwards.
  std::vector<Cell> regions() {
    std::vector<Cell> found;
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column)
        if (cell(column, row).region.pixels > 0) found.push_back(take_region(column, row));
    return found;
  }

 private:
  Cell& cell(int column, int row) {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }

  Cell take_region(int column, int row) {
    Cell whole;
    std::vector<Pixel> waiting;
    const auto take = [&](int c, int r) {
      if (c < 0 || r < 0 || c >= columns_ || r >= rows_ || cell(c, r).region.pixels == 0) return;
      join(whole, cell(c, r));
      cell(c, r) = {};
      waiting.push_back({c, r});
    };
    take(column, row);
    while (!waiting.empty()) {
      const Pixel at = waiting.back();
      waiting.pop_back();
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) take(at.x + dx, at.y + dy);
    }
    return whole;
  }

  int columns_, rows_;
  std::vector<Cell> cells_;
};

double box_rms(const Raster& reference, const Raster& test, SampleUnit unit, const Region& box) {
  const auto width = static_cast<std::size_t>(reference.width);
  const auto channels = static_cast<std::size_t>(reference.channels);
  std::vector<float> r(width * channels), t(width * channels);
  ErrorSum sum;
  for (int y = box.y0; y < box.y1; ++y) {
    load_row(reference, y, unit, r, width);
    load_row(test, y, unit, t, width);
    for (std::size_t channel = 0; channel < channels; ++channel)
      for (int x = box.x0; x < box.x1; ++x) {
        const std::size_t i = channel * width + static_cast<std::size_t>(x);
        if (!std::isfinite(r[i]) || !std::isfinite(t[i])) continue;
        sum.add(static_cast<double>(t[i]) - static_cast<double>(r[i]));
        ++sum.count;
      }
  }
  return sum.figures(unit.levels(1)).root_mean_square;
}

}  // namespace

std::vector<Region> worst_regions(const Raster& reference, const Raster& test,
                                  const PixelDifferences& differences, std::size_t most) {
  std::vector<Cell> found = Grid(reference.width, reference.height, differences.levels).regions();
  std::stable_sort(found.begin(), found.end(),
                   [](const Cell& a, const Cell& b) { return a.square > b.square; });
  if (found.size() > most) found.resize(most);
  std::vector<Region> regions;
  for (Cell& cell : found) {
    cell.region.root_mean_square = box_rms(reference, test, differences.unit, cell.region);
    regions.push_back(cell.region);
  }
  return regions;
}

}  // namespace trace
