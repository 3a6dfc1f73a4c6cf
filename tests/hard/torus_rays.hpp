// Rays at a torus about the z axis, where it is hard.
#pragma once

#include "geometry/ray.hpp"
#include "tests/support/scene_random.hpp"

namespace trace::hard {

using test::Random;

struct RingShape {
  double major, minor;

  double reach() const { return major + minor; }
  // At an angle about the axis, and about the circle of the tube's centres, `above` its surface.
  Vec3 place(double around, double along, double above = 0) const {
    const double radius = major + (minor + above) * std::cos(along);
    return {radius * std::cos(around), radius * std::sin(around), (minor + above) * std::sin(along)};
  }
};

// Touching the surface in any direction, up to 1e-1 ... 1e-15 of the tube's radius above or below.
Ray touching(Random& random, const RingShape& shape);
// Touching it where it bends both ways, along the lines in which it does not bend.
Ray touching_inside(Random& random, const RingShape& shape);
// Parallel to the axis, on it, and where it touches the tube outside and inside.
Ray beside_axis(Random& random, const RingShape& shape);
// In the plane of symmetry, at any distance from the axis and where it touches the two circles there.
Ray in_plane(Random& random, const RingShape& shape);
// At a place near the shape from 1 ... 1e8 away.
Ray at_ring_from_afar(Random& random, const RingShape& shape);
// From inside the tube.
Ray from_inside(Random& random, const RingShape& shape);

}  // namespace trace::hard
