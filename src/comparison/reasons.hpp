// The words for why two pictures are not within tolerance.
#pragma once

#include <string>

#include "comparison/judge.hpp"
#include "image/raster.hpp"

namespace trace {

// "size differs: 512 x 512 against 256 x 256": the reference's first.
std::string size_reason(const Raster& reference, const Raster& test);

// "channels differ: 3 against 4".
std::string channels_reason(const Raster& reference, const Raster& test);

// "2 samples of the test picture are NaN or infinite, first at pixel (3, 0)".
std::string not_finite_reason(const NotFinite& found);

// "RMSE 3.20 is over 0.5; largest difference 12 is over 4": all that is exceeded, empty where nothing is. A
// figure has two decimals, or as many as it takes to see that it is beyond the limit; whole numbers have
// none.
std::string tolerance_reason(const Tolerance& tolerance, const Measurements& measured);

}  // namespace trace
