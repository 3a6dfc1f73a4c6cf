// The unit sphere x^2 + y^2 + z^2 = 1.
#pragma once

#include "geometry/bounds.hpp"

namespace trace {

struct Sphere {
  Bounds bounds() const { return {Vec3(-1), Vec3(1)}; }

  // Nearest root of |o + t d|^2 = 1, d of unit length: t = b -+ sqrt(b^2 - o.o + 1), b = -o.d; from the
  // outside the near one, from the inside or from the surface inward the far one. The normal points outward
  // and has unit length. d is normalized once more here, as in the course's renderer: it changes the last
  // bit, and that shows in cube maps.
  bool intersect(const Ray& ray, LocalHit& hit) const;

  // From the surface.
  double distance(const Vec3& p) const;

  Vec2 texture_coordinates(const Vec3& p, const Vec3& normal) const;  // by_direction()
};

}  // namespace trace
