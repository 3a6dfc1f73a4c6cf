// Where and how much two pictures differ, as a picture.
#pragma once

#include "image/image.hpp"
#include "image/raster.hpp"

namespace trace {

inline constexpr int legend_height = 20;       // pixels
inline constexpr int least_legend_width = 16;  // pixels
inline constexpr int least_label_width = 96;   // pixels

// Each pixel's difference (the largest magnitude over its channels, in levels) in the colours of viridis.hpp:
// dark violet for 0, yellow for 255 / amplify levels and more. Magenta, which is not on that scale, where
// either picture has a sample that is not finite.
//
// Below the picture a band of legend_height rows has the scale from left to right on black; in maps of at
// least least_label_width it is labelled in levels at its start, middle and end. A map narrower than
// least_legend_width has no band and is exactly as large as the pictures.
//
// Needs equal width, height and channels, and amplify > 0.
Image heat_map(const Raster& reference, const Raster& test, double amplify = 1);

}  // namespace trace
