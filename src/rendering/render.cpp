#include "rendering/render.hpp"

#include <algorithm>
#include <array>

#include "rendering/antialias.hpp"
#include "rendering/blocks.hpp"
#include "rendering/pixel.hpp"

namespace trace {
namespace {

constexpr int tile_edge = 16;

// Calls visit(i, j) for the pixels of a tile in the order of packets: blocks of four by four, whose halves
// are compact too.
template <class Visit>
void for_each_in_blocks(int x0, int y0, int x1, int y1, Visit&& visit) {
  for (int top = y0; top < y1; top += 4) {
    for (int left = x0; left < x1; left += 4) {
      for (int j = top; j < std::min(top + 4, y1); ++j) {
        for (int i = left; i < std::min(left + 4, x1); ++i) visit(i, j);
      }
    }
  }
}

// In one loop, which the compiler makes vectors of.
void to_bytes(const double* channel, std::size_t count, std::uint8_t* bytes) {
  for (std::size_t k = 0; k < count; ++k) bytes[k] = to_byte(clamped(channel[k]));
}

void render_pixels(FrameRenderer& frame, Image& image) {
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
        set_pixel(image, i, j, color.value);
      } else {
        std::uint8_t* p = pixel(image, i, j);
        p[0] = red[k];
        p[1] = green[k];
        p[2] = blue[k];
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
  Rendered result;
  result.image.width = options.width;
  result.image.height = height;
  result.image.rgb.resize(static_cast<std::size_t>(options.width) * static_cast<std::size_t>(height) * 3);

  const auto pixels = static_cast<std::uint64_t>(options.width) * static_cast<std::uint64_t>(height);
  const bool refine = options.antialiasing.enabled && options.antialiasing.supersamples > 1;
  progress.total = refine ? 2 * pixels : pixels;
  FrameRenderer frame(scene, tree, options, height, threads_or_all(options.threads), progress);
  if (options.blocks.threshold > 0) {
    render_blocks(frame, result.image);
  } else {
    render_pixels(frame, result.image);
  }
  if (refine) antialias(frame, result.image);
  result.rays = frame.counts();
  result.non_finite = frame.non_finite().found();
  return result;
}

}  // namespace trace
