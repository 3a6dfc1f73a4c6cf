// The comparison of two 8-bit pictures in the shape reports have it, with the figures the page shows most.
#pragma once

#include <nlohmann/json.hpp>

#include "image/image.hpp"

namespace trace::test {

// Verdict by the usual tolerance: RMSE <= 0.5, at most 0.1 % of pixels off by more than a level. One worst
// region: the box around the pixels that are off by more than half of the largest difference.
nlohmann::ordered_json sample_comparison(const Image& solution, const Image& picture);

// Black where the pictures are equal, brighter with their difference.
Image sample_heat(const Image& solution, const Image& picture);

}  // namespace trace::test
