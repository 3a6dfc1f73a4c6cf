// What the stages of one picture share: the scene, its hierarchy, the camera's rays, threads and counters.
#pragma once

#include <algorithm>
#include <vector>

#include "parallel/parallel.hpp"
#include "rendering/non_finite.hpp"
#include "rendering/options.hpp"
#include "rendering/progress.hpp"
#include "scene/camera.hpp"
#include "shading/packet_tracer.hpp"

namespace trace {

class FrameRenderer {
 public:
  FrameRenderer(const Scene& scene, const SceneTree& tree, const RenderOptions& options, int height,
                int threads, Progress& progress)
      : traced_(scene, tree, options.shading),
        options_(options),
        caster_(scene.camera),
        height_(height),
        progress_(progress),
        non_finite_(options.width, height),
        counts_(static_cast<std::size_t>(threads)) {}

  // Colours of points of the picture, for one thread.
  class Sampler {
   public:
    Sampler(const FrameRenderer& frame, RayCounts& counts)
        : caster_(frame.caster_),
          tracer_(frame.traced_, counts),
          packets_(frame.traced_, frame.options_.instruction_set, counts),
          depth_(frame.options_.depth),
          width_(frame.options_.width),
          height_(frame.height_) {}

    // (0, 0) is the lower left corner of the picture, (1, 1) the upper right.
    PartialRgb at(double x, double y) const { return tracer_.trace(caster_.cast(x, y), depth_); }
    // The sample of a pixel is its lower left corner; j counts from the bottom.
    PartialRgb pixel(int i, int j) const { return pixel(column(i), row(j)); }

    // The same in two steps, for whole tiles.
    Vec3 column(int i) const { return caster_.across(i / static_cast<double>(width_)); }
    Vec3 row(int j) const { return caster_.upward(j / static_cast<double>(height_)); }
    PartialRgb pixel(const Vec3& column, const Vec3& row) const {
      return tracer_.trace(caster_.cast(column, row), depth_);
    }

    // Many at once. Those that it leaves out are to be asked for one by one.
    void trace(SampleBatch& batch) const { packets_.trace(batch, depth_); }
    // What a batch takes for a point of the picture.
    Vec3 direction(double x, double y) const { return caster_.across(x) + caster_.upward(y); }

   private:
    RayCaster caster_;
    WhittedTracer tracer_;
    PacketTracer packets_;
    int depth_, width_, height_;
  };

  const RenderOptions& options() const { return options_; }
  int width() const { return options_.width; }
  int height() const { return height_; }

  // Calls body(sampler, x0, y0, x1, y1) for every tile of the picture, or of a grid of other size, half-open,
  // on all threads; tiles begin at multiples of `edge`.
  template <class Body>
  void for_each_tile(int edge, Body&& body) {
    for_each_tile(width(), height(), edge, body);
  }
  template <class Body>
  void for_each_tile(int width, int height, int edge, Body&& body);

  // Whoever has traced a sample of a pixel shows it to this.
  NonFiniteMap& non_finite() { return non_finite_; }
  const NonFiniteMap& non_finite() const { return non_finite_; }

  RayCounts counts() const {
    RayCounts sum;
    for (const ThreadCounts& counts : counts_) sum += counts.rays;
    return sum;
  }

 private:
  TracedScene traced_;
  const RenderOptions& options_;
  RayCaster caster_;
  int height_;
  Progress& progress_;
  NonFiniteMap non_finite_;
  struct alignas(64) ThreadCounts {  // a cache line of its own
    RayCounts rays;
  };
  std::vector<ThreadCounts> counts_;  // a thread each
};

template <class Body>
void FrameRenderer::for_each_tile(int width, int height, int edge, Body&& body) {
  const int columns = (width + edge - 1) / edge, rows = (height + edge - 1) / edge;
  const auto tiles = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  const auto sampler_of = [&](int thread) {
    return Sampler(*this, counts_[static_cast<std::size_t>(thread)].rays);
  };
  const int threads = static_cast<int>(counts_.size());
  parallel_for_with(threads, tiles, sampler_of, [&](std::size_t tile, const Sampler& sampler) {
    const int x0 = static_cast<int>(tile % static_cast<std::size_t>(columns)) * edge;
    const int y0 = static_cast<int>(tile / static_cast<std::size_t>(columns)) * edge;
    const int x1 = std::min(x0 + edge, width), y1 = std::min(y0 + edge, height);
    body(sampler, x0, y0, x1, y1);
    progress_.done += static_cast<std::uint64_t>(x1 - x0) * static_cast<std::uint64_t>(y1 - y0);
  });
}

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

}  // namespace trace
