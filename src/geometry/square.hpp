// The unit square |x|, |y| <= 1/2 in the plane z = 0.
#pragma once

#include "geometry/bounds.hpp"

namespace trace {

struct Square {
  // Thick by 1e-8 either way, as the course has it. The language's test of boxes has no tolerance, so this
  // decides which rays along the rim of a square are asked at all.
  Bounds bounds() const { return {Vec3(-0.5, -0.5, -1e-8), Vec3(0.5, 0.5, 1e-8)}; }

  // Edges included. The normal always faces the ray: (0,0,-1) for a ray going up, else (0,0,1). u = x + 1/2,
  // v = y + 1/2.
  bool intersect(const Ray& ray, LocalHit& hit) const;

  // From the plane of the square.
  double distance(const Vec3& p) const;
};

}  // namespace trace
