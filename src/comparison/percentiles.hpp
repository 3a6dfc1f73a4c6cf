// Percentiles of the pixels' differences, by nearest rank: the p-th percentile of n values is the
// ceil(p / 100 * n)-th smallest, always one of the values.
#pragma once

#include <span>

#include "comparison/measurements.hpp"

namespace trace {

// Negative values are left out. All 0 where none are left.
Percentiles percentiles(std::span<const float> differences);

}  // namespace trace
