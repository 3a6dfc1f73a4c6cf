// Sums of the samples of pixels. They are traced many at once and added in the order in which they were
// given.
#pragma once

#include <array>
#include <vector>

#include "rendering/frame_renderer.hpp"
#include "rendering/pixel.hpp"

namespace trace {

class SampleSums {
 public:
  // `ranges`: finish_with_ranges() is asked for.
  SampleSums(FrameRenderer& frame, const FrameRenderer::Sampler& sampler, bool ranges = false)
      : frame_(frame), sampler_(sampler), ranges_(ranges) {}

  // The samples that follow are of this pixel (j from the bottom) and are added to `start`, in which `count`
  // samples are already.
  void begin(int i, int j, const PartialRgb& start = {}, int count = 0) {
    pixels_.push_back({i, j, count, start, Rgb(1), Rgb(0)});
  }
  // One sample at a point of the picture, (0, 0) to (1, 1); its channels are limited to [0, 1].
  void add(double x, double y) {
    if (samples_.count == SampleBatch::capacity) trace();
    places_[samples_.count] = {x, y, pixels_.size() - 1};
    samples_.add(sampler_.direction(x, y));
    ++pixels_.back().count;
  }
  // n x n samples in the middles of as many equal parts of the pixel, or at another place of each.
  void add_grid(int i, int j, int n, const Vec2& place = Vec2(0.5)) {
    const double width = frame_.width(), height = frame_.height();
    for (int b = 0; b < n; ++b) {
      for (int a = 0; a < n; ++a) add((i + (a + place.x) / n) / width, (j + (b + place.y) / n) / height);
    }
  }
  // Calls visit(i, j, mean) for each pixel in the order of begin(), and starts afresh. A channel that is
  // undefined in any sample is 0.
  template <class Visit>
  void finish(Visit&& visit) {
    finish_with_ranges([&](int i, int j, const Rgb& mean, double) { visit(i, j, mean); });
  }
  // The same with visit(i, j, mean, range), the largest difference of any channel between the samples.
  template <class Visit>
  void finish_with_ranges(Visit&& visit) {
    trace();
    for (const Pixel& p : pixels_) {
      const Rgb range = p.high - p.low;
      visit(p.i, p.j, p.sum.value / static_cast<double>(p.count),
            std::max(range.x, std::max(range.y, range.z)));
    }
    pixels_.clear();
  }

 private:
  struct Pixel {
    int i, j, count;
    PartialRgb sum;
    Rgb low, high;  // of the samples, where ranges are wanted
  };
  struct Place {
    double x, y;
    std::size_t pixel;
  };

  void trace() {
    sampler_.trace(samples_);
    for (std::size_t k = 0; k < samples_.count; ++k) {
      const Place& place = places_[k];
      Pixel& p = pixels_[place.pixel];
      if (samples_.left_out[k]) {
        const PartialRgb sample = sampler_.at(place.x, place.y);
        frame_.non_finite().watch(p.i, p.j, sample);
        add(p, PartialRgb(clamped(sample.value), sample.undefined));
      } else {
        add(p, PartialRgb(clamped(samples_.color(k))));
      }
    }
    samples_.count = 0;
  }

  void add(Pixel& p, const PartialRgb& sample) const {
    p.sum += sample;
    if (!ranges_) return;
    p.low = glm::min(p.low, sample.value);
    p.high = glm::max(p.high, sample.value);
  }

  FrameRenderer& frame_;
  const FrameRenderer::Sampler& sampler_;
  bool ranges_;
  std::vector<Pixel> pixels_;
  SampleBatch samples_;
  std::array<Place, SampleBatch::capacity> places_;
};

}  // namespace trace
