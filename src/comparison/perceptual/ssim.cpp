#include "comparison/perceptual/ssim.hpp"

#include <cmath>

#include "comparison/perceptual/convolution.hpp"
#include "comparison/perceptual/shown_color.hpp"
#include "comparison/vector_clones.hpp"

namespace trace {
namespace {

constexpr int window_side = 11;
constexpr double window_deviation = 1.5;
constexpr float c1 = (0.01F * 255) * (0.01F * 255);
constexpr float c2 = (0.03F * 255) * (0.03F * 255);

// One direction of the window for a picture with this many pixels in it.
std::vector<float> weights(int side) {
  const int taps = std::min(window_side, side % 2 ? side : side - 1);
  std::vector<double> gaussian;
  double sum = 0;
  for (int i = 0; i < taps; ++i) {
    const double distance = i - taps / 2;
    gaussian.push_back(std::exp(-distance * distance / (2 * window_deviation * window_deviation)));
    sum += gaussian.back();
  }
  std::vector<float> normal;
  for (double weight : gaussian) normal.push_back(static_cast<float>(weight / sum));
  return normal;
}

// In levels.
float luma_of(float r, float g, float b) {
  return 255 * (0.299F * r + 0.587F * g + 0.114F * b);
}

TRACE_VECTOR_CLONES void luma_row(const float* __restrict rgb, float* __restrict luma, std::size_t width) {
  for (std::size_t x = 0; x < width; ++x) luma[x] = luma_of(rgb[3 * x], rgb[3 * x + 1], rgb[3 * x + 2]);
}

void load_luma(const Raster& raster, const Tile& tile, Plane& luma) {
  luma.resize(tile.width(), tile.height());
  for (int y = 0; y < luma.height(); ++y) {
    float* row = luma.row(y);
    const float* pixel = raster.pixel(tile.x0, tile.y0 + y);
    if (raster.type != SampleType::real && raster.channels == 3) {  // nothing to clamp
      luma_row(pixel, row, static_cast<std::size_t>(luma.width()));
    } else {
      for (int x = 0; x < luma.width(); ++x, pixel += raster.channels) {
        const auto [r, g, b] = shown_color(pixel, raster.channels);
        row[x] = luma_of(r, g, b);
      }
    }
  }
}

void average(const Plane& in, const SsimWindow& window, Plane& scratch, Plane& out) {
  filter_rows(in, window.across, scratch);
  filter_columns(scratch, window.down, out);
}

// The rows of a^2 + b^2 and of 2 a b.
TRACE_VECTOR_CLONES void multiply_row(const float* a, const float* b, float* __restrict squares,
                                      float* __restrict product, std::size_t width) {
  for (std::size_t x = 0; x < width; ++x) {
    squares[x] = a[x] * a[x] + b[x] * b[x];
    product[x] = 2 * (a[x] * b[x]);
  }
}

// A row of the index from the windows' means of a, b, a^2 + b^2 and 2 a b.
TRACE_VECTOR_CLONES void index_row(const float* a, const float* b, const float* squares, const float* product,
                                   float* __restrict index, std::size_t width) {
  for (std::size_t x = 0; x < width; ++x) {
    const float twice_ab = 2 * (a[x] * b[x]), squared = a[x] * a[x] + b[x] * b[x];
    const float twice_covariance = product[x] - twice_ab, variances = squares[x] - squared;
    index[x] = (twice_ab + c1) * (twice_covariance + c2) / ((squared + c1) * (variances + c2));
  }
}

// The sum of the index over a tile of window positions.
double tile_sum(const Raster& reference, const Raster& test, const SsimWindow& window, const Tile& tile,
                Ssim::Scratch& memory) {
  const Tile seen{tile.x0, tile.y0, tile.x1 + static_cast<int>(window.across.size()) - 1,
                  tile.y1 + static_cast<int>(window.down.size()) - 1};
  auto& [a, b, squares, product, scratch, mean_a, mean_b, mean_squares, mean_product] = memory;
  load_luma(reference, seen, a);
  load_luma(test, seen, b);
  squares.resize(a.width(), a.height());
  product.resize(a.width(), a.height());
  for (int y = 0; y < a.height(); ++y)
    multiply_row(a.row(y), b.row(y), squares.row(y), product.row(y), static_cast<std::size_t>(a.width()));
  average(a, window, scratch, mean_a);
  average(b, window, scratch, mean_b);
  average(squares, window, scratch, mean_squares);
  average(product, window, scratch, mean_product);

  double sum = 0;
  std::vector<float> index(static_cast<std::size_t>(tile.width()));
  for (int y = 0; y < tile.height(); ++y) {
    index_row(mean_a.row(y), mean_b.row(y), mean_squares.row(y), mean_product.row(y), index.data(),
              index.size());
    for (float value : index) sum += static_cast<double>(value);
  }
  return sum;
}

}  // namespace

Ssim::Ssim(const Raster& reference, const Raster& test, const std::vector<float>& differences)
    : reference_(reference), test_(test), window_{weights(reference.width), weights(reference.height)} {
  const int reach_x = static_cast<int>(window_.across.size()) - 1;
  const int reach_y = static_cast<int>(window_.down.size()) - 1;
  const int columns = reference.width - reach_x, rows = reference.height - reach_y;
  positions_ = static_cast<double>(columns) * rows;
  tiles_ = tiles_that_differ(columns, rows, 0, std::max(reach_x, reach_y), differences, reference.width);
  sums_.resize(tiles_.size());
}

void Ssim::measure_part(std::size_t part, Scratch& scratch) {
  sums_[part] = tile_sum(reference_, test_, window_, tiles_[part], scratch);
}

double Ssim::mean() const {
  double missing = 0;  // elsewhere the index is 1
  for (std::size_t i = 0; i < tiles_.size(); ++i)
    missing += static_cast<double>(tiles_[i].width()) * tiles_[i].height() - sums_[i];
  return 1 - missing / positions_;
}

}  // namespace trace
