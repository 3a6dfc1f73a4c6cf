// What the stages of one picture share: the scene, its hierarchy, the camera's rays, threads and counters.
#pragma once

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "rendering/options.hpp"
#include "rendering/progress.hpp"
#include "scene/camera.hpp"

namespace trace {

class FrameRenderer {
 public:
  FrameRenderer(const Scene& scene, const SceneTree& tree, const RenderOptions& options, int height,
                Progress& progress)
      : scene_(scene),
        tree_(tree),
        options_(options),
        caster_(scene.camera),
        height_(height),
        progress_(progress) {}

  // Colours of points of the picture, for one thread.
  class Sampler {
   public:
    Sampler(const FrameRenderer& frame, RayCounts& counts)
        : caster_(frame.caster_),
          tracer_(frame.scene_, frame.tree_, frame.options_.shading, counts),
          depth_(frame.options_.depth),
          width_(frame.options_.width),
          height_(frame.height_) {}

    // (0, 0) is the lower left corner of the picture, (1, 1) the upper right.
    Rgb at(double x, double y) const { return tracer_.trace(caster_.cast(x, y), depth_); }
    // The sample of a pixel is its lower left corner; j counts from the bottom.
    Rgb pixel(int i, int j) const { return pixel(column(i), row(j)); }

    // The same in two steps, for whole tiles.
    Vec3 column(int i) const { return caster_.across(i / static_cast<double>(width_)); }
    Vec3 row(int j) const { return caster_.upward(j / static_cast<double>(height_)); }
    Rgb pixel(const Vec3& column, const Vec3& row) const {
      return tracer_.trace(caster_.cast(column, row), depth_);
    }

   private:
    RayCaster caster_;
    WhittedTracer tracer_;
    int depth_, width_, height_;
  };

  const RenderOptions& options() const { return options_; }
  int width() const { return options_.width; }
  int height() const { return height_; }

  // Calls body(sampler, x0, y0, x1, y1) for every tile of the picture, half-open, on all threads; tiles begin
  // at multiples of `edge`.
  template <class Body>
  void for_each_tile(int edge, Body&& body);

  RayCounts counts() const {
    return counts_.combine([](RayCounts a, const RayCounts& b) { return a += b; });
  }

 private:
  const Scene& scene_;
  const SceneTree& tree_;
  const RenderOptions& options_;
  RayCaster caster_;
  int height_;
  Progress& progress_;
  mutable tbb::enumerable_thread_specific<RayCounts> counts_;
};

template <class Body>
void FrameRenderer::for_each_tile(int edge, Body&& body) {
  const int columns = (width() + edge - 1) / edge, rows = (height_ + edge - 1) / edge;
  tbb::parallel_for(
      tbb::blocked_range<std::int64_t>(0, std::int64_t{columns} * rows, 1),
      [&](const tbb::blocked_range<std::int64_t>& range) {
        const Sampler sampler(*this, counts_.local());
        for (std::int64_t tile = range.begin(); tile != range.end(); ++tile) {
          const int x0 = static_cast<int>(tile % columns) * edge,
                    y0 = static_cast<int>(tile / columns) * edge;
          const int x1 = std::min(x0 + edge, width()), y1 = std::min(y0 + edge, height_);
          body(sampler, x0, y0, x1, y1);
          progress_.done += static_cast<std::uint64_t>(x1 - x0) * static_cast<std::uint64_t>(y1 - y0);
        }
      },
      tbb::simple_partitioner());
}

}  // namespace trace
