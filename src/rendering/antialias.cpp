#include "rendering/antialias.hpp"

#include <array>

#include "rendering/sample_sums.hpp"

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

}  // namespace

void antialias(FrameRenderer& frame, Film& film) {
  const Image& image = film.image();
  const int n = frame.options().antialiasing.supersamples;
  const std::vector<std::uint8_t> marks = mark(image, frame.options().antialiasing.threshold * 0.001);
  // Samples lie on the grid of a picture n times as large: column k of it is at k * (1 / columns), in this
  // form, which decides whether a sample touches a silhouette.
  const double step_x = 1.0 / (static_cast<double>(image.width) * n);
  const double step_y = 1.0 / (static_cast<double>(image.height) * n);

  frame.for_each_tile(16, [&](const FrameRenderer::Sampler& sampler, int x0, int y0, int x1, int y1) {
    SampleSums sums(frame, sampler);
    for (int j = y0; j < y1; ++j) {
      for (int i = x0; i < x1; ++i) {
        if (!marks[static_cast<std::size_t>(j) * static_cast<std::size_t>(image.width) +
                   static_cast<std::size_t>(i)]) {
          continue;
        }
        const std::uint8_t* p = pixel(image, i, j);
        sums.begin(i, j, PartialRgb(Rgb(p[0] / 255.0, p[1] / 255.0, p[2] / 255.0)), 1);
        for (int a = 0; a < n; ++a) {
          for (int b = a == 0 ? 1 : 0; b < n; ++b) {
            sums.add((static_cast<double>(i) * n + a) * step_x, (static_cast<double>(j) * n + b) * step_y);
          }
        }
      }
    }
    sums.finish([&](int i, int j, const Rgb& mean) { film.set(i, j, mean); });
  });
}

}  // namespace trace
