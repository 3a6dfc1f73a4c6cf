// What is known of how a picture differs from its reference. Plain data; measure.hpp fills it.
//
// Errors are in levels: 1/255 of full scale, whatever the sample type. A difference is test minus reference.
// A pixel's difference is the largest magnitude over its channels. Pixels are counted from the top left, from
// 0.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace trace {

struct Pixel {
  int x = 0, y = 0;
};

// Half-open: x0 <= x < x1.
struct Region {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  std::size_t pixels = 0;       // in it that are off by more than a level
  double root_mean_square = 0;  // over the box, in levels
};

struct ErrorFigures {
  double mean_absolute = 0;
  double root_mean_square = 0;
  double peak_signal_to_noise = std::numeric_limits<double>::infinity();  // dB, for a peak of 255 levels
  double mean_signed = 0;
  double largest = 0;
};

struct LargestDifference {
  Pixel pixel;
  int channel = 0;
  double reference = 0, test = 0;  // levels
};

struct Percentiles {
  double p50 = 0, p90 = 0, p99 = 0, p999 = 0;  // of the pixels' differences
};

// Over the pixels where either picture is not background.
struct Foreground {
  std::size_t pixels = 0;
  ErrorFigures error;
  double percent_over_one = 0;  // of these pixels
};

// Each pixel's difference replaced by the least over the 3x3 neighbourhood, in both directions.
struct EdgeTolerant {
  double root_mean_square = 0, largest = 0, percent_over_one = 0;
};

struct NotFinite {
  std::size_t reference = 0, test = 0;  // samples that are NaN or infinite
  Pixel first;                          // the first pixel with one, if there is any
};

struct Measurements {
  int width = 0, height = 0, channels = 0;
  ErrorFigures error;                 // over all channels
  std::vector<ErrorFigures> channel;  // of each
  LargestDifference largest;
  double percent_different = 0;  // share of pixels that differ at all
  double percent_over_one = 0;   // by more than one level
  double threshold = 1;          // levels, of the next
  double percent_over_threshold = 0;
  Percentiles percentiles;
  // Absent where they were not asked for, and where a sample is not finite.
  std::optional<double> ssim;  // mean; 1 is equal
  std::optional<double> flip;  // mean; 0 is equal
  Foreground foreground;
  EdgeTolerant edge_tolerant;
  NotFinite not_finite;
  std::vector<Region> worst;  // connected regions, worst first, at most three

  bool identical() const { return error.largest == 0 && not_finite.reference + not_finite.test == 0; }
};

}  // namespace trace
