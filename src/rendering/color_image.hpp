// A picture before it is cut to bytes.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/vector.hpp"

namespace trace {

// Colours from 0 to 1, rows from top to bottom, as floats: their step of 2^-24 is 1/66000 of a level.
class ColorImage {
 public:
  ColorImage() = default;
  ColorImage(int width, int height)
      : width_(width),
        height_(height),
        samples_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3) {}

  int width() const { return width_; }
  int height() const { return height_; }
  // Red, green and blue of each pixel in turn.
  const std::vector<float>& samples() const { return samples_; }
  std::vector<float>& samples() { return samples_; }

  void set(int x, int y, const Rgb& color) {
    float* p = &samples_[index(x, y)];
    for (int channel = 0; channel < 3; ++channel) p[channel] = static_cast<float>(color[channel]);
  }
  Rgb at(int x, int y) const {
    const float* p = &samples_[index(x, y)];
    return {p[0], p[1], p[2]};
  }

 private:
  std::size_t index(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)) * 3;
  }

  int width_ = 0, height_ = 0;
  std::vector<float> samples_;
};

}  // namespace trace
