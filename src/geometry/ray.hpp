// A ray, and what a primitive reports of its nearest intersection with one.
#pragma once

#include <cstdint>

#include "geometry/vector.hpp"

namespace trace {

struct Ray {
  Vec3 origin;
  Vec3 direction;  // unit length

  Vec3 at(double t) const { return origin + t * direction; }
};

// A hit counts only where t, in the space of the object, exceeds this. The value is the language's: the
// course's renderer lets an occluder 1.000001e-8 away cast its shadow and drops one 1.000000e-8 away, and
// secondary rays start exactly at the hit point, so it is what keeps a surface from shadowing itself.
inline constexpr double min_t = 1e-8;

// In the space of the object. Primitives fill what they have: `normal` need not be of unit length, `uv` is
// the place in a texture (box and square only), `part` and `uv` of a mesh are the face and the barycentric
// weights of its second and third corner.
struct LocalHit {
  double t = 0;
  Vec3 normal{0, 0, 1};
  Vec2 uv{0, 0};
  std::uint32_t part = 0;
};

}  // namespace trace
