// The unit cube [-1/2, 1/2]^3.
#pragma once

#include "geometry/bounds.hpp"

namespace trace {

struct Box {
  Bounds bounds() const { return {Vec3(-0.5), Vec3(0.5)}; }

  // Nearest face, edges included; of faces at the same t the first in the order -x -y -z +x +y +z. Where a
  // ray passes between two faces by rounding it meets the inside of the box beyond, as in the course's
  // pictures, but it does not pass the whole box: that is a gap (LocalHit). The normal points outward. Each
  // face shows a whole texture: with lo < hi the two axes of the face, u = 1/2 -+ p[lo] (minus on the -x -y
  // -z faces), v = 1/2 + p[hi].
  bool intersect(const Ray& ray, LocalHit& hit) const;

  // From the face that the normal of a hit belongs to.
  double distance(const Vec3& p, const Vec3& normal) const;
};

}  // namespace trace
