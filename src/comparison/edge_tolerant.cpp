#include "comparison/edge_tolerant.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "comparison/vector_clones.hpp"

namespace trace {
namespace {

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();  // is no neighbour's match

// The rows y - 1, y and y + 1 of a picture, one plane a channel, with a column of `nothing` at either side.
class ThreeRows {
 public:
  ThreeRows(const Raster& raster, SampleUnit unit)
      : raster_(raster),
        unit_(unit),
        stride_(static_cast<std::size_t>(raster.width) + 2),
        channels_(static_cast<std::size_t>(raster.channels)) {
    for (auto& row : rows_) row.resize(stride_ * channels_);
    held_.fill(-2);
  }

  void center(int y) {
    for (int row = y - 1; row <= y + 1; ++row) {
      int& held = held_[slot(row)];
      if (held != row) load(row);
      held = row;
    }
  }

  // Sample x is at [x]; [-1] and [width] may be read.
  const float* plane(int y, std::size_t channel) const { return &rows_[slot(y)][channel * stride_ + 1]; }

 private:
  static std::size_t slot(int y) { return static_cast<std::size_t>(y + 3) % 3; }

  void load(int y) {
    std::vector<float>& row = rows_[slot(y)];
    std::fill(row.begin(), row.end(), nothing);
    if (y < 0 || y >= raster_.height) return;
    load_row(raster_, y, unit_, std::span(row).subspan(1), stride_);
    if (unit_.whole) return;
    for (float& sample : row)
      if (!std::isfinite(sample)) sample = nothing;
  }

  const Raster& raster_;
  SampleUnit unit_;
  std::size_t stride_, channels_;
  std::array<std::vector<float>, 3> rows_;
  std::array<int, 3> held_{};
};

// difference = max(difference, |p - q|), NaN where either is.
TRACE_VECTOR_CLONES void widen(const float* p, const float* q, float* __restrict difference,
                               std::size_t width) {
  for (std::size_t x = 0; x < width; ++x) {
    const float size = std::abs(p[x] - q[x]);
    difference[x] = difference[x] >= size ? difference[x] : size;
  }
}

// least = min(least, difference), where that is a number.
TRACE_VECTOR_CLONES void narrow(const float* difference, float* __restrict least, std::size_t width) {
  for (std::size_t x = 0; x < width; ++x) least[x] = difference[x] < least[x] ? difference[x] : least[x];
}

// The least difference of each pixel of row y of `picture` from its neighbourhood in `other`.
void least_differences(const ThreeRows& picture, const ThreeRows& other, int y, std::size_t channels,
                       std::vector<float>& least, std::vector<float>& difference) {
  std::fill(least.begin(), least.end(), std::numeric_limits<float>::infinity());
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      std::fill(difference.begin(), difference.end(), 0.0F);
      for (std::size_t channel = 0; channel < channels; ++channel)
        widen(picture.plane(y, channel), other.plane(y + dy, channel) + dx, difference.data(), least.size());
      narrow(difference.data(), least.data(), least.size());
    }
}

}  // namespace

EdgeTolerant edge_tolerant(const Raster& reference, const Raster& test, const PixelDifferences& differences) {
  const auto width = static_cast<std::size_t>(reference.width);
  const auto channels = static_cast<std::size_t>(reference.channels);
  ThreeRows reference_rows(reference, differences.unit), test_rows(test, differences.unit);
  std::vector<float> of_test(width), of_reference(width), scratch(width);
  const double per_unit = differences.unit.levels(1), one = with_slack(1) / per_unit;
  double square = 0, largest = 0;  // in units
  std::size_t pixels = 0, over_one = 0;
  for (int y = 0; y < reference.height; ++y) {
    const float* levels = &differences.levels[static_cast<std::size_t>(y) * width];
    if (!differences.row_differs[static_cast<std::size_t>(y)]) {
      pixels += width;
      continue;
    }
    reference_rows.center(y);
    test_rows.center(y);
    least_differences(test_rows, reference_rows, y, channels, of_test, scratch);
    least_differences(reference_rows, test_rows, y, channels, of_reference, scratch);
    for (std::size_t x = 0; x < width; ++x) {
      if (levels[x] == left_out) continue;
      ++pixels;
      const float farthest = std::max(of_test[x], of_reference[x]);
      const double units = static_cast<double>(std::min(farthest, std::numeric_limits<float>::max()));
      square += units * units;
      largest = std::max(largest, units);
      over_one += units > one;
    }
  }
  if (pixels == 0) return {};
  const auto n = static_cast<double>(pixels);
  return {std::sqrt(square / n) * per_unit, differences.unit.levels(largest),
          100 * static_cast<double>(over_one) / n};
}

}  // namespace trace
