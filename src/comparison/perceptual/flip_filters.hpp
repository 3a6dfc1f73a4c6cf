// FLIP's filters for pictures seen at 67.0206 pixels a degree; all are separable.
#pragma once

#include <vector>

namespace trace {

struct FlipFilters {
  using Taps = std::vector<float>;  // an odd number, the middle one for the pixel itself

  // The eye's contrast sensitivity (section 4.1.1 and table 1 of the paper), each adding up to 1 in two
  // dimensions: for light and dark, red and green, and blue and yellow, the last of which is the sum of two
  // Gaussians.
  Taps light, red_green, blue_yellow_1, blue_yellow_2;
  // The feature detectors (section 4.2): a Gaussian and its first and second derivative, their negative and
  // their positive weights adding up to -1 and 1.
  Taps smooth, edge, point;
};

// How far the filters reach.
inline constexpr int color_radius = 10;   // pixels
inline constexpr int feature_radius = 9;  // pixels

FlipFilters flip_filters();

}  // namespace trace
