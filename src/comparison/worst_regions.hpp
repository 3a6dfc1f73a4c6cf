// Where the pictures differ most.
#pragma once

#include <vector>

#include "comparison/measurements.hpp"
#include "comparison/pixel_differences.hpp"

namespace trace {

// Connected regions of pixels that are off by more than one level, the largest sum of squared differences
// first, at most `most` of them. Pixels are gathered in cells of 4 x 4 and cells connected with their eight
// neighbours, so that small gaps do not split a region: pixels at most 4 apart in either direction are always
// in one region, and a gap of 7 pixels always parts them.
std::vector<Region> worst_regions(const Raster& reference, const Raster& test,
                                  const PixelDifferences& differences, std::size_t most = 3);

}  // namespace trace
