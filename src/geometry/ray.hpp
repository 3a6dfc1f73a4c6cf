// A ray, and what a primitive reports of its nearest intersection with one.
#pragma once

#include <cstdint>

#include "geometry/vector.hpp"

namespace trace {

// What the course's renderer has instead: it drops every hit nearer than this in the space of the object. It
// decides here only where bounds of errors leave open what is right.
inline constexpr double course_least_t = 1e-8;

// There is no smallest distance for a hit. A ray that leaves a surface knows instead how well its origin is
// known, and a hit is dropped exactly where the origin cannot be told from lying on the surface that is hit
// (docs/numerics.md).
struct Ray {
  Vec3 origin;
  Vec3 direction;  // unit length

  // How far, in each coordinate, the origin may be from the surface that it is meant to lie on.
  double origin_error = 0;
  // Hits up to here lie within that error above the surface that the ray leaves.
  double least_t = 0;

  Vec3 at(double t) const { return origin + t * direction; }
};

// In the space of the object. Primitives fill what they have: `normal` need not be of unit length, `uv` is
// the place in a texture (box and square only), `part` and `uv` of a mesh are the face and the barycentric
// weights of its second and third corner.
struct LocalHit {
  double t = 0;
  Vec3 normal{0, 0, 1};
  Vec2 uv{0, 0};
  std::uint32_t part = 0;
  bool is_gap = false;  // hit where the course's renderer has a pinhole; what else is at the place goes first
};

}  // namespace trace
