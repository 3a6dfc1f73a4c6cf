#include "rendering/antialias.hpp"

#include <array>

#include "rendering/pixel.hpp"

namespace trace {
namespace {

double distance(const std::uint8_t* a, const std::uint8_t* b) {
  return glm::length(Rgb(a[0] - b[0], a[1] - b[1], a[2] - b[2]) / 255.0);
}

constexpr std::array<std::pair<int, int>, 3> neighbours{{{1, 0}, {0, 1}, {1, 1}}};

std::vector<std::uint8_t> mark(const Image& image, double threshold) {
  std::vector<std::uint8_t> marks(image.rgb.size() / 3, 0);
  const auto index = [&](int i, int j) {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(i);
  };
  for (int j = 0; j < image.height; ++j) {
    for (int i = 0; i < image.width; ++i) {
      for (const auto& [di, dj] : neighbours) {
        if (i + di >= image.width || j + dj >= image.height) continue;
        if (distance(pixel(image, i, j), pixel(image, i + di, j + dj)) > threshold) {
          marks[index(i, j)] = marks[index(i + di, j + dj)] = 1;
        }
      }
    }
  }
  return marks;
}

// Adds samples to the pixels of a tile. They are traced many at once and added in the order in which they
// were given.
class Refinement {
 public:
  Refinement(FrameRenderer& frame, const FrameRenderer::Sampler& sampler, Image& image)
      : frame_(frame), sampler_(sampler), image_(image) {}

  // The samples that follow are of this pixel, which has its first already.
  void begin(int i, int j) {
    const std::uint8_t* p = pixel(image_, i, j);
    pixels_.push_back({i, j, PartialRgb(Rgb(p[0] / 255.0, p[1] / 255.0, p[2] / 255.0))});
  }
  void add(double x, double y) {
    if (samples_.count == SampleBatch::capacity) trace();
    places_[samples_.count] = {x, y, pixels_.size() - 1};
    samples_.add(sampler_.direction(x, y));
  }
  void finish() {
    trace();
    const int n = frame_.options().antialiasing.supersamples;
    for (const Pixel& p : pixels_) set_pixel(image_, p.i, p.j, p.sum.value / static_cast<double>(n * n));
  }

 private:
  struct Pixel {
    int i, j;
    PartialRgb sum;
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
        p.sum += PartialRgb(clamped(sample.value), sample.undefined);
      } else {
        p.sum += PartialRgb(clamped(samples_.color(k)));
      }
    }
    samples_.count = 0;
  }

  FrameRenderer& frame_;
  const FrameRenderer::Sampler& sampler_;
  Image& image_;
  std::vector<Pixel> pixels_;
  SampleBatch samples_;
  std::array<Place, SampleBatch::capacity> places_;
};

}  // namespace

void antialias(FrameRenderer& frame, Image& image) {
  const int n = frame.options().antialiasing.supersamples;
  const std::vector<std::uint8_t> marks = mark(image, frame.options().antialiasing.threshold * 0.001);
  // Samples lie on the grid of a picture n times as large: column k of it is at k * (1 / columns), in this
  // form, which decides whether a sample touches a silhouette.
  const double step_x = 1.0 / (static_cast<double>(image.width) * n);
  const double step_y = 1.0 / (static_cast<double>(image.height) * n);

  frame.for_each_tile(16, [&](const FrameRenderer::Sampler& sampler, int x0, int y0, int x1, int y1) {
    Refinement refinement(frame, sampler, image);
    for (int j = y0; j < y1; ++j) {
      for (int i = x0; i < x1; ++i) {
        if (!marks[static_cast<std::size_t>(j) * static_cast<std::size_t>(image.width) +
                   static_cast<std::size_t>(i)]) {
          continue;
        }
        refinement.begin(i, j);
        for (int a = 0; a < n; ++a) {
          for (int b = a == 0 ? 1 : 0; b < n; ++b) {
            refinement.add((static_cast<double>(i) * n + a) * step_x,
                           (static_cast<double>(j) * n + b) * step_y);
          }
        }
      }
    }
    refinement.finish();
  });
}

}  // namespace trace
