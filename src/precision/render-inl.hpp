// A picture in one kind of number; one source for each, for they are large to compile.
#pragma once

#include <chrono>

#include "parallel/parallel.hpp"
#include "precision/render_as.hpp"
#include "precision/whitted.hpp"
#include "rendering/render.hpp"

namespace trace::precision {

// Limited to [0, 1]; NaN becomes 0.
template <class T>
double shown(T channel) {
  return channel > 0 ? static_cast<double>(std::min(channel, T(1))) : 0;
}

template <class T>
ArithmeticPicture render_as(const Scene& given, const SceneTree& tree, const RenderOptions& options,
                            int threads) {
  ArithmeticPicture picture;
  picture.width = options.width;
  picture.height = static_cast<int>(picture_height(given, options.width));
  const auto width = static_cast<std::size_t>(picture.width),
             height = static_cast<std::size_t>(picture.height);
  picture.colors.resize(3 * width * height);
  const SceneIn<T> scene(given);
  const Search<T> search(scene, tree);
  struct alignas(64) ThreadCounts {
    RayCounts rays;
  };
  std::vector<ThreadCounts> counts(static_cast<std::size_t>(threads));
  const auto start = std::chrono::steady_clock::now();
  parallel_for(threads, height, [&](std::size_t row, int thread) {
    const WhittedTracer<T> tracer(scene, search, options.shading,
                                  counts[static_cast<std::size_t>(thread)].rays);
    const T y = static_cast<T>(height - 1 - row) / static_cast<T>(height);
    for (std::size_t column = 0; column < width; ++column) {
      const T x = static_cast<T>(column) / static_cast<T>(width);
      const Vec3<T> color = tracer.trace(scene.camera.cast(x, y), options.depth);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        picture.colors[3 * (row * width + column) + channel] = shown(color[static_cast<int>(channel)]);
      }
    }
  });
  picture.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  for (const ThreadCounts& c : counts) picture.rays += c.rays;
  return picture;
}

}  // namespace trace::precision
