// What a row of one channel contributes to the figures of error.
#pragma once

#include <cstddef>

#include "comparison/error_sum.hpp"

namespace trace {

// Rows to be summed are filled up with equal samples to a multiple of this.
inline constexpr std::size_t row_block = 8;

// The sums of test - reference over `width` samples, a multiple of row_block; no count. `levels` of each
// pixel becomes the larger of itself and the difference's magnitude in levels, except where it is `left_out`,
// which is for samples that are equal.
ErrorSum sum_row(const float* reference, const float* test, float levels_per_unit, float* levels,
                 std::size_t width);

}  // namespace trace
