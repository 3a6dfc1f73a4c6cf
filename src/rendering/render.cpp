#include "rendering/render.hpp"

#include <algorithm>
#include <array>

#include "rendering/adaptive.hpp"
#include "rendering/antialias.hpp"
#include "rendering/blocks.hpp"
#include "rendering/nine_points.hpp"
#include "rendering/uniform.hpp"

namespace trace {
namespace {

constexpr int tile_edge = 16;

// In one loop, which the compiler makes vectors of.
void to_bytes(const double* channel, std::size_t count, std::uint8_t* bytes) {
  for (std::size_t k = 0; k < count; ++k) bytes[k] = to_byte(clamped(channel[k]));
}

// One sample a pixel, at its corner.
void render_pixels(FrameRenderer& frame, Film& film) {
  static_assert(tile_edge * tile_edge <= SampleBatch::capacity);
  frame.for_each_tile(tile_edge, [&](const FrameRenderer::Sampler& sampler, int x0, int y0, int x1, int y1) {
    SampleBatch batch;
    std::array<Vec3, tile_edge> columns;
    for (int i = x0; i < x1; ++i) columns[static_cast<std::size_t>(i - x0)] = sampler.column(i);
    std::array<Vec3, tile_edge> rows;
    for (int j = y0; j < y1; ++j) rows[static_cast<std::size_t>(j - y0)] = sampler.row(j);
    for_each_in_blocks(x0, y0, x1, y1, [&](int i, int j) {
      batch.add(columns[static_cast<std::size_t>(i - x0)] + rows[static_cast<std::size_t>(j - y0)]);
    });
    sampler.trace(batch);
    std::uint8_t red[SampleBatch::capacity], green[SampleBatch::capacity], blue[SampleBatch::capacity];
    to_bytes(batch.red, batch.count, red);
    to_bytes(batch.green, batch.count, green);
    to_bytes(batch.blue, batch.count, blue);
    std::size_t k = 0;
    for_each_in_blocks(x0, y0, x1, y1, [&](int i, int j) {
      if (batch.left_out[k]) {
        const PartialRgb color = sampler.pixel(i, j);
        frame.non_finite().watch(i, j, color);
        film.set(i, j, color.value);
      } else {
        std::uint8_t* p = pixel(film.image(), i, j);
        p[0] = red[k];
        p[1] = green[k];
        p[2] = blue[k];
        if (film.keeps_colors()) film.colors().set(i, frame.height() - 1 - j, clamped(batch.color(k)));
      }
      ++k;
    });
  });
}

}  // namespace

double picture_height(const Scene& scene, int width) {
  return std::floor(scene.camera.picture_height(width));
}

Rendered render(const Scene& scene, const SceneTree& tree, const RenderOptions& options, Progress& progress) {
  const int height = static_cast<int>(picture_height(scene, options.width));
  Film film(options.width, height, options.keep_colors);
  const auto pixels = static_cast<std::uint64_t>(options.width) * static_cast<std::uint64_t>(height);
  const bool refine = options.antialiasing.enabled && options.antialiasing.supersamples > 1;
  progress.total = refine ? 2 * pixels : pixels;
  FrameRenderer frame(scene, tree, options, height, threads_or_all(options.threads), progress);
  const Sampling& sampling = options.sampling;
  if (sampling.threshold > 0) {
    progress.total = 3 * pixels;
    render_adaptive(frame, film, grids_for_threshold(sampling.threshold, sampling.most));
  } else if (sampling.nine_points) {
    render_nine_points(frame, film);
  } else if (sampling.grid > 1) {
    render_uniform(frame, film, sampling.grid);
  } else {
    if (options.blocks.threshold > 0) {
      render_blocks(frame, film);
    } else {
      render_pixels(frame, film);
    }
    if (refine) antialias(frame, film);
  }
  return {std::move(film.image()), std::move(film.colors()), frame.counts(), frame.non_finite().found()};
}

}  // namespace trace
