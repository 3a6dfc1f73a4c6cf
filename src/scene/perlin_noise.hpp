// Noise in space.
#pragma once

#include "geometry/vector.hpp"

namespace trace {

// Perlin's improved noise (K. Perlin, "Improving Noise", SIGGRAPH 2002, with the permutation of his reference
// implementation): between about -1 and 1, 0 at points with whole coordinates, repeating after 256. 0 where a
// coordinate is not finite.
double perlin_noise(const Vec3& p);

}  // namespace trace
