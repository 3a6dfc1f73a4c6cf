// Rays at a cylinder or cone around the z axis, where it is hard.
#pragma once

#include "geometry/ray.hpp"
#include "tests/support/scene_random.hpp"

namespace trace::hard {

using test::Random;

// Radius at z = 0 and at z = `height`.
struct RoundShape {
  double bottom, top, height;

  double radius(double z) const { return bottom + (top - bottom) * (z / height); }
  Vec3 on_side(double angle, double z) const {
    return {radius(z) * std::cos(angle), radius(z) * std::sin(angle), z};
  }
};

// Along the axis, at any distance from it up to 3/2 radii and at the radius itself, a few ulps off.
Ray along_axis(Random& random, const RoundShape& shape);
// The same, tilted by 1e-1 ... 1e-12.
Ray almost_along_axis(Random& random, const RoundShape& shape);
// Beside a line of the side by 1e-1 ... 1e-9, from beyond its ends.
Ray along_generator(Random& random, const RoundShape& shape);
// On a line of the side, up to rounding, from beyond its ends.
Ray on_generator(Random& random, const RoundShape& shape);
// Touching the side, up to 1e-1 ... 1e-15 above or below.
Ray tangent(Random& random, const RoundShape& shape);
// At the circle where side and cap meet.
Ray at_rim(Random& random, const RoundShape& shape);
// At the apex of a cone, which must not be a cylinder.
Ray at_apex(Random& random, const RoundShape& shape);
// At a place near the shape from 1 ... 1e8 away.
Ray from_afar(Random& random, const RoundShape& shape);

}  // namespace trace::hard
