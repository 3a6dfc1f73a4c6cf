// The unit square |x|, |y| <= 1/2 in the plane z = 0.
#pragma once

#include "geometry/bounds.hpp"

namespace trace {

struct Square {
  // Thick by min_t either way: the box test before the square has no tolerance of its own.
  Bounds bounds() const { return {Vec3(-0.5, -0.5, -min_t), Vec3(0.5, 0.5, min_t)}; }

  // Edges included. The normal always faces the ray: (0,0,-1) for a ray going up, else (0,0,1). u = x + 1/2,
  // v = y + 1/2.
  bool intersect(const Ray& ray, LocalHit& hit) const;
};

}  // namespace trace
