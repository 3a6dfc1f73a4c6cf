// What a screen shows of a pixel, for the figures that model an observer.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "image/raster.hpp"

namespace trace {

using ShownColor = std::array<float, 3>;

// R, G and B in [0, 1]: gray in all three, alpha and further channels ignored, values outside of [0, 1]
// clamped, those that are not finite as 0.
inline ShownColor shown_color(const float* pixel, int channels) {
  const auto clamped = [](float value) {
    return std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 0.0F;
  };
  if (channels < 3) return {clamped(pixel[0]), clamped(pixel[0]), clamped(pixel[0])};
  return {clamped(pixel[0]), clamped(pixel[1]), clamped(pixel[2])};
}

}  // namespace trace
