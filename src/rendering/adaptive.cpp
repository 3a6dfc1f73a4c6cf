#include "rendering/adaptive.hpp"

#include "rendering/sample_sums.hpp"

namespace trace {
namespace {

constexpr int corner_tile = 16;
constexpr int edge = 64;  // of tiles whose contrasts are found at once
static_assert(corner_tile * corner_tile <= SampleBatch::capacity);

}  // namespace

CornerSamples::CornerSamples(FrameRenderer& frame)
    : columns_(frame.width() + 1),
      colors_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(frame.height() + 1)) {
  const double width = frame.width(), height = frame.height();
  const auto trace_tile = [&](const FrameRenderer::Sampler& sampler, int x0, int y0, int x1, int y1) {
    SampleBatch batch;
    const auto for_each = [&](auto&& visit) { for_each_in_blocks(x0, y0, x1, y1, visit); };
    for_each([&](int i, int j) { batch.add(sampler.direction(i / width, j / height)); });
    sampler.trace(batch);
    std::size_t k = 0;
    for_each([&](int i, int j) {
      Rgb color = batch.left_out[k] ? Rgb(0) : batch.color(k);
      if (batch.left_out[k]) {
        const PartialRgb sample = sampler.at(i / width, j / height);
        frame.non_finite().watch(std::min(i, frame.width() - 1), std::min(j, frame.height() - 1), sample);
        color = sample.value;
      }
      color = clamped(color);
      colors_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
              static_cast<std::size_t>(i)] = {static_cast<float>(color.x), static_cast<float>(color.y),
                                              static_cast<float>(color.z)};
      ++k;
    });
  };
  frame.for_each_tile(frame.width() + 1, frame.height() + 1, corner_tile, trace_tile);
}

Rgb CornerSamples::mean(int i, int j) const {
  const Color &a = at(i, j), &b = at(i + 1, j), &c = at(i, j + 1), &d = at(i + 1, j + 1);
  return {(double{a.r} + b.r + c.r + d.r) / 4, (double{a.g} + b.g + c.g + d.g) / 4,
          (double{a.b} + b.b + c.b + d.b) / 4};
}

float CornerSamples::contrast(int i, int j) const {
  const Color &a = at(i, j), &b = at(i + 1, j), &c = at(i, j + 1), &d = at(i + 1, j + 1);
  const auto range = [](float p, float q, float r, float s) {
    return std::max(std::max(p, q), std::max(r, s)) - std::min(std::min(p, q), std::min(r, s));
  };
  return 255 *
         std::max(range(a.r, b.r, c.r, d.r), std::max(range(a.g, b.g, c.g, d.g), range(a.b, b.b, c.b, d.b)));
}

std::vector<std::uint8_t> CornerSamples::contrasts(FrameRenderer& frame) const {
  const int width = frame.width(), height = frame.height();
  std::vector<std::uint8_t> bins(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  frame.for_each_tile(
      width, height, edge, [&](const FrameRenderer::Sampler&, int x0, int y0, int x1, int y1) {
        // With a border of one pixel, 0 outside the picture.
        std::array<std::array<float, edge + 2>, edge + 2> own{};
        for (int j = std::max(y0 - 1, 0); j < std::min(y1 + 1, height); ++j) {
          for (int i = std::max(x0 - 1, 0); i < std::min(x1 + 1, width); ++i) {
            own[static_cast<std::size_t>(j - y0 + 1)][static_cast<std::size_t>(i - x0 + 1)] = contrast(i, j);
          }
        }
        for (int j = y0; j < y1; ++j) {
          for (int i = x0; i < x1; ++i) {
            const auto y = static_cast<std::size_t>(j - y0 + 1), x = static_cast<std::size_t>(i - x0 + 1);
            float around = 0;
            for (std::size_t q = y - 1; q <= y + 1; ++q) {
              around = std::max(around, std::max(own[q][x - 1], std::max(own[q][x], own[q][x + 1])));
            }
            bins[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(i)] =
                static_cast<std::uint8_t>(contrast_bin(std::max(own[y][x], around / 4)));
          }
        }
      });
  return bins;
}

void refine(FrameRenderer& frame, Film& film, const CornerSamples& corners,
            const std::vector<std::uint8_t>& contrasts, const GridByContrast& grids) {
  frame.for_each_tile(16, [&](const FrameRenderer::Sampler& sampler, int x0, int y0, int x1, int y1) {
    SampleSums sums(frame, sampler);
    for (int j = y0; j < y1; ++j) {
      for (int i = x0; i < x1; ++i) {
        const std::size_t pixel = static_cast<std::size_t>(j) * static_cast<std::size_t>(frame.width()) +
                                  static_cast<std::size_t>(i);
        const int n = grids[contrasts[pixel]];
        if (n == 0) {
          film.set(i, j, corners.mean(i, j));
        } else {
          sums.begin(i, j);
          sums.add_grid(i, j, n);
        }
      }
    }
    sums.finish([&](int i, int j, const Rgb& mean) { film.set(i, j, mean); });
  });
}

void render_adaptive(FrameRenderer& frame, Film& film, const GridByContrast& grids) {
  const CornerSamples corners(frame);
  refine(frame, film, corners, corners.contrasts(frame), grids);
}

}  // namespace trace
