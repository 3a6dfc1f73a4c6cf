#include "rendering/nine_points.hpp"

#include "rendering/pixel.hpp"

namespace trace {
namespace {

// The points of a tile of pixels, half a pixel apart.
class Lattice {
 public:
  Lattice(FrameRenderer& frame, int x0, int y0, int x1, int y1)
      : frame_(frame),
        x0_(x0),
        y0_(y0),
        columns_(2 * (x1 - x0) + 1),
        rows_(2 * (y1 - y0) + 1),
        colors_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

  void trace(const FrameRenderer::Sampler& sampler) {
    SampleBatch batch;
    for (std::size_t first = 0; first < colors_.size(); first += SampleBatch::capacity) {
      const std::size_t count = std::min(SampleBatch::capacity, colors_.size() - first);
      batch.count = 0;
      for (std::size_t k = first; k < first + count; ++k) batch.add(sampler.direction(x(k), y(k)));
      sampler.trace(batch);
      for (std::size_t k = 0; k < count; ++k) {
        PartialRgb color =
            batch.left_out[k] ? sampler.at(x(first + k), y(first + k)) : PartialRgb(batch.color(k));
        if (batch.left_out[k]) watch(first + k, color);
        colors_[first + k] = PartialRgb(clamped(color.value), color.undefined);
      }
    }
  }

  Rgb mean(int i, int j) const {
    PartialRgb sum;
    for (int b = 0; b < 3; ++b) {
      for (int a = 0; a < 3; ++a) {
        sum += colors_[static_cast<std::size_t>(2 * (j - y0_) + b) * static_cast<std::size_t>(columns_) +
                       static_cast<std::size_t>(2 * (i - x0_) + a)];
      }
    }
    return sum.value / 9.0;
  }

 private:
  int column(std::size_t k) const { return static_cast<int>(k % static_cast<std::size_t>(columns_)); }
  int row(std::size_t k) const { return static_cast<int>(k / static_cast<std::size_t>(columns_)); }
  double x(std::size_t k) const { return (x0_ + 0.5 * column(k)) / frame_.width(); }
  double y(std::size_t k) const { return (y0_ + 0.5 * row(k)) / frame_.height(); }
  // Shows it to one of the pixels that have the point.
  void watch(std::size_t k, const PartialRgb& color) {
    frame_.non_finite().watch(x0_ + std::min(column(k), columns_ - 2) / 2,
                              y0_ + std::min(row(k), rows_ - 2) / 2, color);
  }

  FrameRenderer& frame_;
  int x0_, y0_, columns_, rows_;
  std::vector<PartialRgb> colors_;  // rows from the bottom
};

}  // namespace

void render_nine_points(FrameRenderer& frame, Film& film) {
  frame.for_each_tile(16, [&](const FrameRenderer::Sampler& sampler, int x0, int y0, int x1, int y1) {
    Lattice lattice(frame, x0, y0, x1, y1);
    lattice.trace(sampler);
    for (int j = y0; j < y1; ++j) {
      for (int i = x0; i < x1; ++i) film.set(i, j, lattice.mean(i, j));
    }
  });
}

}  // namespace trace
