// Separable filters on small planes of numbers.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace trace {

// Rows of floats with room behind each, so that loops may run over the end of a row in whole vectors.
class Plane {
 public:
  static constexpr std::size_t spare = 32;  // numbers

  Plane() = default;
  Plane(int width, int height) { resize(width, height); }

  void resize(int width, int height) {
    width_ = width;
    height_ = height;
    stride_ = (static_cast<std::size_t>(width) + spare - 1) / spare * spare + spare;
    const std::size_t needed = stride_ * static_cast<std::size_t>(height);
    if (values_.size() < needed) values_.resize(needed);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  float* row(int y) { return &values_[static_cast<std::size_t>(y) * stride_]; }
  const float* row(int y) const { return &values_[static_cast<std::size_t>(y) * stride_]; }
  std::size_t stride() const { return stride_; }

 private:
  int width_ = 0, height_ = 0;
  std::size_t stride_ = 0;
  std::vector<float> values_;
};

// out(x, y) = sum over k of taps[k] in(x + k, y), for every x at which all taps lie in the plane.
void filter_rows(const Plane& in, std::span<const float> taps, Plane& out);

// out(x, y) = sum over k of taps[k] in(x, y + k).
void filter_columns(const Plane& in, std::span<const float> taps, Plane& out);

// The part of `in` without `margin` at each side.
void cut(const Plane& in, int margin, Plane& out);

}  // namespace trace
