#include "comparison/row_sums.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "comparison/vector_clones.hpp"

namespace trace {
namespace {

constexpr float most_float = std::numeric_limits<float>::max();

// Sample i goes to lane i mod row_block, so that the order of additions is the same on every machine and can
// still be done for several samples at once.
struct Lanes {
  std::array<double, row_block> magnitude{}, square{}, sum{};
  std::array<float, row_block> largest{};
};

TRACE_VECTOR_CLONES void add_row(const float* __restrict r, const float* __restrict t, float levels_per_unit,
                                 float* __restrict levels, std::size_t width, Lanes& total) {
  Lanes lanes = total;
  for (std::size_t x = 0; x < width; x += row_block)
    for (std::size_t lane = 0; lane < row_block; ++lane) {
      const float raw = t[x + lane] - r[x + lane];
      const float above = raw > -most_float ? raw : -most_float;
      const float difference = above < most_float ? above : most_float;
      const float size = std::abs(difference);
      const auto exact = static_cast<double>(difference);
      lanes.magnitude[lane] += std::abs(exact);
      lanes.square[lane] += exact * exact;
      lanes.sum[lane] += exact;
      lanes.largest[lane] = lanes.largest[lane] > size ? lanes.largest[lane] : size;
      const float scaled = size * levels_per_unit;
      const float level = scaled < most_float ? scaled : most_float;
      const float before = levels[x + lane];
      levels[x + lane] = before < 0 || before > level ? before : level;
    }
  total = lanes;
}

}  // namespace

ErrorSum sum_row(const float* reference, const float* test, float levels_per_unit, float* levels,
                 std::size_t width) {
  Lanes lanes;
  add_row(reference, test, levels_per_unit, levels, width, lanes);
  ErrorSum sum;
  for (std::size_t lane = 0; lane < row_block; ++lane)
    sum += {0, lanes.magnitude[lane], lanes.square[lane], lanes.sum[lane],
            static_cast<double>(lanes.largest[lane])};
  return sum;
}

}  // namespace trace
