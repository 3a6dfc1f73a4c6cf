// The first pass over two pictures: what every sample contributes, and how far each pixel is off.
#pragma once

#include <cstddef>
#include <vector>

#include "comparison/error_sum.hpp"
#include "comparison/measurements.hpp"
#include "comparison/sample_rows.hpp"

namespace trace {

// A pixel with a sample that is not finite has this "difference": it takes no part in figures of pixels.
inline constexpr float left_out = -1;

// Rounding of floating-point samples must not decide whether a pixel is off by "more than one level".
inline constexpr double rounding_slack = 1e-4;  // levels

// A limit of 0 is for what is identical: it has no slack.
inline double with_slack(double levels) {
  return levels > 0 ? levels + rounding_slack : levels;
}

inline bool over(float difference, double levels) {
  return difference > static_cast<float>(with_slack(levels));
}

struct PixelDifferences {
  SampleUnit unit;
  std::vector<ErrorSum> channel;  // in units
  // Where either picture is not background. That is wherever they differ, so the sums over the foreground are
  // those over all; only the counts are others.
  std::size_t foreground_pixels = 0;
  std::size_t foreground_samples = 0;
  NotFinite not_finite;
  LargestDifference largest;
  double largest_units = 0;
  // Of each pixel, rows from the top: the largest magnitude over its channels, in levels, or `left_out`.
  std::vector<float> levels;
  std::vector<char> row_differs;  // where anything in the row does
};

// The same for any number of threads.
PixelDifferences pixel_differences(const Raster& reference, const Raster& test, unsigned threads = 1);

}  // namespace trace
