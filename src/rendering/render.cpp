#include "rendering/render.hpp"

#include <algorithm>
#include <array>
#include <thread>

#include "rendering/antialias.hpp"
#include "rendering/blocks.hpp"
#include "rendering/pixel.hpp"

namespace trace {
namespace {

constexpr int tile_edge = 16;

void render_pixels(FrameRenderer& frame, Image& image) {
  frame.for_each_tile(tile_edge, [&](const FrameRenderer::Sampler& sampler, int x0, int y0, int x1, int y1) {
    std::array<Vec3, tile_edge> columns;
    for (int i = x0; i < x1; ++i) columns[static_cast<std::size_t>(i - x0)] = sampler.column(i);
    for (int j = y0; j < y1; ++j) {
      const Vec3 row = sampler.row(j);
      for (int i = x0; i < x1; ++i) {
        const PartialRgb color = sampler.pixel(columns[static_cast<std::size_t>(i - x0)], row);
        frame.non_finite().watch(i, j, color);
        set_pixel(image, i, j, color.value);
      }
    }
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
  const int threads =
      options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency());
  FrameRenderer frame(scene, tree, options, height, std::max(threads, 1), progress);
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
