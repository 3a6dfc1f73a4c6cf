// A score that a shifted edge leaves small and a wrong surface does not.
#pragma once

#include "comparison/measurements.hpp"
#include "comparison/pixel_differences.hpp"

namespace trace {

// For each pixel the larger of two minima over its 3x3 neighbourhood (cut off at the picture's edge): that of
// the test's pixel against the reference's neighbourhood, and that of the reference's pixel against the
// test's neighbourhood. Only with both is a thin thing seen that is missing, or one that is too much. A
// difference of two pixels is the largest over the channels. The root mean square is over the pixels.
EdgeTolerant edge_tolerant(const Raster& reference, const Raster& test, const PixelDifferences& differences);

}  // namespace trace
