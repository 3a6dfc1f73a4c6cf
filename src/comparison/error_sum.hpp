// The sums behind ErrorFigures.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "comparison/measurements.hpp"

namespace trace {

// Of differences in any one unit; `figures` makes them levels.
struct ErrorSum {
  std::size_t count = 0;
  double magnitude = 0, square = 0, sum = 0, largest = 0;

  void add(double difference) {
    const double size = std::abs(difference);
    magnitude += size;
    square += difference * difference;
    sum += difference;
    largest = std::max(largest, size);
  }

  void operator+=(const ErrorSum& other) {
    count += other.count;
    magnitude += other.magnitude;
    square += other.square;
    sum += other.sum;
    largest = std::max(largest, other.largest);
  }

  // All 0 (and an infinite PSNR) for no differences at all. The PSNR is 20 log10(255 / RMSE).
  ErrorFigures figures(double levels_per_unit) const {
    ErrorFigures result;
    if (count == 0) return result;
    const auto n = static_cast<double>(count);
    result.mean_absolute = magnitude / n * levels_per_unit;
    result.root_mean_square = std::sqrt(square / n) * levels_per_unit;
    result.mean_signed = sum / n * levels_per_unit;
    result.largest = largest * levels_per_unit;
    if (result.root_mean_square > 0)
      result.peak_signal_to_noise = 20 * std::log10(255 / result.root_mean_square);
    return result;
  }
};

}  // namespace trace
