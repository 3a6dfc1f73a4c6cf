// Pixels whose colour is not a number: infinite or undefined in some channel (shading/partial_rgb.hpp).
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "shading/partial_rgb.hpp"

namespace trace {

// What is known of them after a render. A pixel counts if any sample traced for it is not finite; pixels
// filled by block interpolation are not traced.
struct NonFinitePixels {
  std::uint64_t count = 0;
  int x = 0, y = 0;              // of the first in reading order, from the top left; if there is one
  Channels undefined, infinite;  // of that one's samples; a channel may be in both
};

// "12 pixels have a colour that is not finite, the first at (31, 40): green is undefined and drawn black".
// `found` has at least one.
std::string to_text(const NonFinitePixels& found);

// The memory of one render: a byte a pixel, from the first such pixel on.
class NonFiniteMap {
 public:
  NonFiniteMap(int width, int height) : width_(width), height_(height) {}

  // `color` is a sample of the pixel in column i and row j from the bottom. Of one pixel it is called by one
  // thread at a time, of different ones by any.
  void watch(int i, int j, const PartialRgb& color) {
    if (!color.finite()) [[unlikely]]
      note(i, j, color);
  }

  // The same for any number of threads. Not while any thread watches.
  NonFinitePixels found() const;

 private:
  void note(int i, int j, const PartialRgb& color);

  int width_, height_;
  std::once_flag allocated_;
  std::vector<std::uint8_t> marks_;  // in reading order: bits 0 to 2 undefined, 3 to 5 infinite channels
};

}  // namespace trace
