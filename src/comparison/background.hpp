// The colour in front of which a scene stands.
#pragma once

#include <vector>

#include "image/raster.hpp"

namespace trace {

// The colour of more than half of the pixels on the picture's border (its outermost rows and columns), as
// stored in all channels; black (0 in every channel) where no colour has that majority.
std::vector<float> background_of(const Raster& reference);

}  // namespace trace
