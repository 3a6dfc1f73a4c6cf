#include "comparison/worst_regions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "comparison/row_sums.hpp"

namespace trace {
namespace {

constexpr int cell_side = 4;  // pixels

struct Cell {
  std::uint32_t pixels = 0;  // that are off by more than a level
  float square = 0;          // sum of their squared differences
};

struct Found {
  std::vector<Pixel> cells;
  double square = 0;
};

class Grid {
 public:
  Grid(int width, int height, const PixelDifferences& differences)
      : width_(width),
        height_(height),
        levels_(differences.levels),
        columns_((width + cell_side - 1) / cell_side),
        rows_((height + cell_side - 1) / cell_side),
        cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
    for (int y = 0; y < height; ++y)
      if (differences.row_differs[static_cast<std::size_t>(y)]) gather(y);
  }

  // In order of their topmost cells, which are empty afterwards.
  std::vector<Found> regions() {
    std::vector<Found> found;
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column)
        if (cell(column, row).pixels > 0) found.push_back(take_region(column, row));
    return found;
  }

  // The box around the pixels of these cells that are off.
  Region box(const std::vector<Pixel>& cells) const {
    Region box{width_, height_, 0, 0, 0, 0};
    for (const Pixel& at : cells)
      for (int y = at.y * cell_side; y < std::min(height_, (at.y + 1) * cell_side); ++y)
        for (int x = at.x * cell_side; x < std::min(width_, (at.x + 1) * cell_side); ++x) {
          if (!over(row(y)[x], 1)) continue;
          ++box.pixels;
          box.x0 = std::min(box.x0, x);
          box.y0 = std::min(box.y0, y);
          box.x1 = std::max(box.x1, x + 1);
          box.y1 = std::max(box.y1, y + 1);
        }
    return box;
  }

 private:
  const float* row(int y) const {
    return &levels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_)];
  }

  Cell& cell(int column, int row) {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }

  void gather(int y) {
    const float* levels = row(y);
    for (int column = 0; column < columns_; ++column) {
      Cell& to = cell(column, y / cell_side);
      const int end = std::min(width_, (column + 1) * cell_side);
      for (int x = column * cell_side; x < end; ++x) {
        const bool off = over(levels[x], 1);
        to.pixels += off;
        // Sums beyond the largest number are alike: infinite.
        to.square += off ? levels[x] * levels[x] : 0;
      }
    }
  }

  Found take_region(int column, int row) {
    Found whole;
    std::vector<Pixel> waiting;
    const auto take = [&](int c, int r) {
      if (c < 0 || r < 0 || c >= columns_ || r >= rows_ || cell(c, r).pixels == 0) return;
      whole.square += static_cast<double>(cell(c, r).square);
      cell(c, r) = {};
      waiting.push_back({c, r});
    };
    take(column, row);
    while (!waiting.empty()) {
      const Pixel at = waiting.back();
      waiting.pop_back();
      whole.cells.push_back(at);
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) take(at.x + dx, at.y + dy);
    }
    return whole;
  }

  int width_, height_;
  const std::vector<float>& levels_;
  int columns_, rows_;
  std::vector<Cell> cells_;
};

// Of all samples in the box that are finite in both pictures.
double box_rms(const Raster& reference, const Raster& test, SampleUnit unit, const Region& box) {
  const auto width = static_cast<std::size_t>(reference.width);
  const auto channels = static_cast<std::size_t>(reference.channels);
  const auto left = static_cast<std::size_t>(box.x0), count = static_cast<std::size_t>(box.x1 - box.x0);
  std::vector<float> r(width * channels), t(width * channels);
  const std::size_t padded = (count + row_block - 1) / row_block * row_block;
  std::vector<float> in_box_r(padded), in_box_t(padded), ignored(padded);
  ErrorSum sum;
  sum.count = count * channels * static_cast<std::size_t>(box.y1 - box.y0);
  for (int y = box.y0; y < box.y1; ++y) {
    load_row(reference, y, unit, r, width);
    load_row(test, y, unit, t, width);
    for (std::size_t channel = 0; channel < channels; ++channel) {
      std::copy_n(&r[channel * width + left], count, in_box_r.begin());
      std::copy_n(&t[channel * width + left], count, in_box_t.begin());
      for (std::size_t x = 0; !unit.whole && x < count; ++x) {
        if (std::isfinite(in_box_r[x]) && std::isfinite(in_box_t[x])) continue;
        in_box_r[x] = in_box_t[x] = 0;
        --sum.count;
      }
      sum += sum_row(in_box_r.data(), in_box_t.data(), 1, ignored.data(), padded);
    }
  }
  return sum.figures(unit.levels(1)).root_mean_square;
}

}  // namespace

std::vector<Region> worst_regions(const Raster& reference, const Raster& test,
                                  const PixelDifferences& differences, std::size_t most) {
  Grid grid(reference.width, reference.height, differences);
  std::vector<Found> found = grid.regions();
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.square > b.square; });
  if (found.size() > most) found.resize(most);
  std::vector<Region> regions;
  for (const Found& one : found) {
    Region region = grid.box(one.cells);
    region.root_mean_square = box_rms(reference, test, differences.unit, region);
    regions.push_back(region);
  }
  return regions;
}

}  // namespace trace
