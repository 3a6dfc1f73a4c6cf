// A reference and a test picture as the diagnosis looks at them: whole levels, three channels.
//
// A cause that is worth a sentence moves pixels by many levels, so that 8 bits are enough here whatever the
// files hold. "Differs" means by more than one level in some channel: one level is what rounding instead of
// truncating does.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

#include "comparison/diagnosis/diagnosis.hpp"
#include "image/image.hpp"

namespace trace {

// With fewer differing pixels than this every cause explains them and none is clear.
inline constexpr std::size_t least_pixels_to_judge = 32;

struct PicturePair {
  int width = 0, height = 0;
  Image reference, test;                 // gray is repeated, alpha left out
  std::vector<std::uint8_t> differs;     // 1 where a pixel does, by rows
  std::vector<std::uint32_t> differing;  // the indices of those pixels, ascending

  const std::uint8_t* of_reference(std::size_t index) const { return &reference.rgb[index * 3]; }
  const std::uint8_t* of_test(std::size_t index) const { return &test.rgb[index * 3]; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

// Nothing where a sample is not finite, or the pictures are not of one size and one to four channels.
std::optional<PicturePair> make_pair(const Raster& reference, const Raster& test);

// Largest difference over the channels, in levels.
inline int distance(const std::uint8_t* a, const std::uint8_t* b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

// A cause that passed its own thresholds, and the share of the squared error (or of the differing pixels, as
// the cause says) that it leaves over.
struct Finding {
  Diagnosis diagnosis;
  double unexplained = 1;
};

}  // namespace trace
