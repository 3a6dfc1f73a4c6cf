#include "comparison/ssim.hpp"

#include <cmath>

#include "comparison/convolution.hpp"
#include "comparison/parallel.hpp"
#include "comparison/shown_color.hpp"
#include "comparison/tiles.hpp"

namespace trace {
namespace {

constexpr int window_side = 11;
constexpr double window_deviation = 1.5;
constexpr float c1 = (0.01F * 255) * (0.01F * 255);
constexpr float c2 = (0.03F * 255) * (0.03F * 255);

// One direction of the window for a picture with this many pixels in it.
std::vector<float> window(int side) {
  const int taps = std::min(window_side, side % 2 ? side : side - 1);
  std::vector<double> weights;
  double sum = 0;
  for (int i = 0; i < taps; ++i) {
    const double distance = i - taps / 2;
    weights.push_back(std::exp(-distance * distance / (2 * window_deviation * window_deviation)));
    sum += weights.back();
  }
  std::vector<float> normal;
  for (double weight : weights) normal.push_back(static_cast<float>(weight / sum));
  return normal;
}

// In levels.
void load_luma(const Raster& raster, const Tile& tile, Plane& luma) {
  luma.resize(tile.width(), tile.height());
  for (int y = 0; y < luma.height(); ++y) {
    float* row = luma.row(y);
    for (int x = 0; x < luma.width(); ++x) {
      const auto [r, g, b] = shown_color(raster.pixel(tile.x0 + x, tile.y0 + y), raster.channels);
      row[x] = 255 * (0.299F * r + 0.587F * g + 0.114F * b);
    }
  }
}

struct Windows {
  std::vector<float> across, down;

  void average(const Plane& in, Plane& scratch, Plane& out) const {
    filter_rows(in, across, scratch);
    filter_columns(scratch, down, out);
  }
};

// The sum of the index over a tile of window positions.
double tile_sum(const Raster& reference, const Raster& test, const Windows& windows, const Tile& tile) {
  const Tile seen{tile.x0, tile.y0, tile.x1 + static_cast<int>(windows.across.size()) - 1,
                  tile.y1 + static_cast<int>(windows.down.size()) - 1};
  Plane a, b, squares, product, scratch;
  load_luma(reference, seen, a);
  load_luma(test, seen, b);
  squares.resize(a.width(), a.height());
  product.resize(a.width(), a.height());
  for (int y = 0; y < a.height(); ++y) {
    const float *pa = a.row(y), *pb = b.row(y);
    float *ps = squares.row(y), *pp = product.row(y);
    for (int x = 0; x < a.width(); ++x) {
      ps[x] = pa[x] * pa[x] + pb[x] * pb[x];
      pp[x] = 2 * (pa[x] * pb[x]);
    }
  }
  Plane mean_a, mean_b, mean_squares, mean_product;
  windows.average(a, scratch, mean_a);
  windows.average(b, scratch, mean_b);
  windows.average(squares, scratch, mean_squares);
  windows.average(product, scratch, mean_product);

  double sum = 0;
  std::vector<float> index(static_cast<std::size_t>(tile.width()));
  for (int y = 0; y < tile.height(); ++y) {
    const float *pa = mean_a.row(y), *pb = mean_b.row(y);
    const float *ps = mean_squares.row(y), *pp = mean_product.row(y);
    for (std::size_t x = 0; x < index.size(); ++x) {
      const float twice_ab = 2 * (pa[x] * pb[x]), squared = pa[x] * pa[x] + pb[x] * pb[x];
      const float twice_covariance = pp[x] - twice_ab, variances = ps[x] - squared;
      index[x] = (twice_ab + c1) * (twice_covariance + c2) / ((squared + c1) * (variances + c2));
    }
    for (float value : index) sum += static_cast<double>(value);
  }
  return sum;
}

}  // namespace

double ssim(const Raster& reference, const Raster& test, const std::vector<float>& differences,
            unsigned threads) {
  const Windows windows{window(reference.width), window(reference.height)};
  const int reach_x = static_cast<int>(windows.across.size()) - 1;
  const int reach_y = static_cast<int>(windows.down.size()) - 1;
  const int columns = reference.width - reach_x, rows = reference.height - reach_y;
  const std::vector<Tile> tiles =
      tiles_that_differ(columns, rows, 0, std::max(reach_x, reach_y), differences, reference.width);
  std::vector<double> sums(tiles.size());
  in_parallel(tiles.size(), threads,
              [&](std::size_t i) { sums[i] = tile_sum(reference, test, windows, tiles[i]); });

  // Elsewhere the index is 1.
  double missing = 0;
  for (std::size_t i = 0; i < tiles.size(); ++i)
    missing += static_cast<double>(tiles[i].width()) * tiles[i].height() - sums[i];
  return 1 - missing / (static_cast<double>(columns) * rows);
}

}  // namespace trace
