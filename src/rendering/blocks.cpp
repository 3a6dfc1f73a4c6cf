#include "rendering/blocks.hpp"

#include <optional>

namespace trace {
namespace {

class Block {
 public:
  Block(FrameRenderer& frame, const FrameRenderer::Sampler& sampler, Film& film, double threshold, int x0,
        int y0, int x1, int y1)
      : frame_(frame),
        sampler_(sampler),
        film_(film),
        threshold_(threshold),
        x0_(x0),
        y0_(y0),
        columns_(x1 - x0) {
    traced_.resize(static_cast<std::size_t>(x1 - x0) * static_cast<std::size_t>(y1 - y0));
  }

  // Pixels x0..x1, y0..y1, both included.
  void fill(int x0, int y0, int x1, int y1) {
    const PartialRgb corners[4] = {color(x0, y0), color(x1, y0), color(x0, y1), color(x1, y1)};
    const bool small = x1 - x0 <= 1 && y1 - y0 <= 1;
    if (small || alike(corners)) {
      interpolate(corners, x0, y0, x1, y1);
      return;
    }
    const int middle_x = x0 + (x1 - x0 + 1) / 2, middle_y = y0 + (y1 - y0 + 1) / 2;
    const bool wide = x1 > x0, tall = y1 > y0;
    fill(x0, y0, wide ? middle_x - 1 : x1, tall ? middle_y - 1 : y1);
    if (wide) fill(middle_x, y0, x1, tall ? middle_y - 1 : y1);
    if (tall) fill(x0, middle_y, wide ? middle_x - 1 : x1, y1);
    if (wide && tall) fill(middle_x, middle_y, x1, y1);
  }

 private:
  const PartialRgb& color(int i, int j) {
    auto& known = traced_[static_cast<std::size_t>(j - y0_) * static_cast<std::size_t>(columns_) +
                          static_cast<std::size_t>(i - x0_)];
    if (!known) {
      const PartialRgb traced = sampler_.pixel(i, j);
      frame_.non_finite().watch(i, j, traced);
      known.emplace(clamped(traced.value), traced.undefined);
    }
    return *known;
  }

  bool alike(const PartialRgb (&corners)[4]) const {
    for (int a = 0; a < 4; ++a) {
      if (corners[a].undefined.any()) return false;
      for (int b = a + 1; b < 4; ++b) {
        if (glm::length(corners[a].value - corners[b].value) > threshold_) return false;
      }
    }
    return true;
  }

  void interpolate(const PartialRgb (&c)[4], int x0, int y0, int x1, int y1) {
    for (int j = y0; j <= y1; ++j) {
      const double t = y1 > y0 ? (j - y0) / static_cast<double>(y1 - y0) : 0;
      for (int i = x0; i <= x1; ++i) {
        const double s = x1 > x0 ? (i - x0) / static_cast<double>(x1 - x0) : 0;
        if ((i == x0 || i == x1) && (j == y0 || j == y1)) {
          film_.set(i, j, color(i, j).value);
        } else {
          film_.set(i, j,
                    c[0].value * (1 - s) * (1 - t) + c[1].value * s * (1 - t) + c[2].value * (1 - s) * t +
                        c[3].value * s * t);
        }
      }
    }
  }

  FrameRenderer& frame_;
  const FrameRenderer::Sampler& sampler_;
  Film& film_;
  double threshold_;
  int x0_, y0_, columns_;
  std::vector<std::optional<PartialRgb>> traced_;
};

}  // namespace

void render_blocks(FrameRenderer& frame, Film& film) {
  const BlockInterpolation& blocks = frame.options().blocks;
  frame.for_each_tile(
      blocks.size, [&](const FrameRenderer::Sampler& sampler, int x0, int y0, int x1, int y1) {
        Block(frame, sampler, film, blocks.threshold * 0.001, x0, y0, x1, y1).fill(x0, y0, x1 - 1, y1 - 1);
      });
}

}  // namespace trace
