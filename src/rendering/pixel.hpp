// From colours to bytes.
#pragma once

#include <cstdint>

#include "geometry/vector.hpp"
#include "image/image.hpp"

namespace trace {

// A channel limited to [0, 1]; infinities too. Never NaN: an undefined channel has the value 0
// (shading/partial_rgb.hpp).
inline double clamped(double c) {
  return c < 0 ? 0 : (c > 1 ? 1 : c);
}
inline Rgb clamped(const Rgb& c) {
  return {clamped(c.x), clamped(c.y), clamped(c.z)};
}

// int(255 c), truncated, of a channel in [0, 1]. No gamma.
inline std::uint8_t to_byte(double c) {
  return static_cast<std::uint8_t>(255 * c);
}

// A pixel of an image by column and row counted from the bottom.
inline std::uint8_t* pixel(Image& image, int i, int j) {
  const auto row = static_cast<std::size_t>(image.height - 1 - j);
  return &image.rgb[(row * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(i)) * 3];
}
inline const std::uint8_t* pixel(const Image& image, int i, int j) {
  const auto row = static_cast<std::size_t>(image.height - 1 - j);
  return &image.rgb[(row * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(i)) * 3];
}

inline void set_pixel(Image& image, int i, int j, const Rgb& color) {
  std::uint8_t* p = pixel(image, i, j);
  for (int channel = 0; channel < 3; ++channel) p[channel] = to_byte(clamped(color[channel]));
}

}  // namespace trace
