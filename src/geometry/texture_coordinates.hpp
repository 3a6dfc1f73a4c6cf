// Texture coordinates of curved surfaces, from a place in the space of the object. Both are in [0, 1]; u
// grows to the right and v upward as one looks at the surface from outside, z (of a sphere y) upward.
#pragma once

#include <algorithm>
#include <numbers>

#include "geometry/vector.hpp"

namespace trace {

inline double in_unit(double x) {
  return std::clamp(x, 0.0, 1.0);
}

// How far round from -x: 1/4 at -y, 1/2 at +x, 3/4 at +y.
inline double turn_around(double x, double y) {
  return in_unit(0.5 + std::atan2(y, x) / (2 * std::numbers::pi));
}

// Of a disk around the z axis.
inline Vec2 across_disk(const Vec3& p, double radius) {
  return {in_unit(0.5 + 0.5 * p.x / radius), in_unit(0.5 + 0.5 * p.y / radius)};
}

// As the course's projects map spheres: with d the unit vector from the place to the centre, u = 0.5 +
// atan2(dx, dz) / 2 pi and v = 0.5 - asin(dy) / pi. So v is 0 at -y and 1 at +y, and u goes round from +z by
// +x, -z (1/2) and -x. The middle of a picture of the earth faces a viewer at -z. The centre itself has (1/2,
// 1/2).
inline Vec2 by_direction(const Vec3& p) {
  const double length = glm::length(p);
  if (!(length > 0)) return Vec2(0.5);
  const Vec3 d = -p / length;
  return {in_unit(0.5 + std::atan2(d.x, d.z) / (2 * std::numbers::pi)),
          in_unit(0.5 - std::asin(std::clamp(d.y, -1.0, 1.0)) / std::numbers::pi)};
}

}  // namespace trace
