// How far one picture of colours is off another, before either is cut to bytes.
#pragma once

#include "rendering/color_image.hpp"

namespace trace {

// In levels (1/255), over all channels of all pixels.
struct PictureError {
  double root_mean_square = 0, mean_absolute = 0, largest = 0;
};

// Both of one size.
PictureError picture_error(const ColorImage& picture, const ColorImage& truth);

// The mean of two pictures of one size.
ColorImage mean(const ColorImage& a, const ColorImage& b);

// A picture whose pixels are samples at their corners (the lower left of each) seen at `width` x `height`: at
// the middle of each pixel between the four samples around it, by distance.
ColorImage enlarged(const ColorImage& picture, int width, int height);

}  // namespace trace
