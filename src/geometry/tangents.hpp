// The directions in which a surface's texture coordinates grow.
#pragma once

#include <optional>

#include "geometry/vector.hpp"

namespace trace {

// Along the surface, of any length: u grows along `along_u` where v does not change, and the other way round.
struct Tangents {
  Vec3 along_u, along_v;
};

// Nothing where they are not finite, one of them is zero, or they are parallel as far as can be told.
inline std::optional<Tangents> checked(const Tangents& t) {
  const double u = glm::dot(t.along_u, t.along_u), v = glm::dot(t.along_v, t.along_v);
  const Vec3 across = glm::cross(t.along_u, t.along_v);
  // The sine of the angle between them: below the root of the unit roundoff, 2^-26, the plane that they span
  // is known to less than half of its digits.
  if (!(u > 0 && v > 0 && glm::dot(across, across) > 0x1p-52 * (u * v))) return std::nullopt;
  if (!(u < 0x1p+1000 && v < 0x1p+1000)) return std::nullopt;
  return t;
}

// From texture coordinates as a function of the point alone, for surfaces that have no simpler way. `normal`
// is at right angles to the surface at `p`. Differences are taken over a step either way of 2^-17 of the
// largest coordinate (at least 2^-17), about the cube root of the unit roundoff, where the errors of the
// second-order formula and of rounding are alike: both near 2^-34 of the derivatives. Coordinates that repeat
// may jump by a whole number in between.
template <class Coordinates>
std::optional<Tangents> tangents_by_differences(const Coordinates& coordinates, const Vec3& p,
                                                const Vec3& normal) {
  const Vec3 size = glm::abs(normal), at = glm::abs(p);
  const int axis = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
  Vec3 other(0);
  other[axis] = 1;
  const Vec3 a = glm::normalize(glm::cross(normal, other)), b = glm::normalize(glm::cross(normal, a));
  const double step = 0x1p-17 * glm::max(1.0, glm::max(at.x, glm::max(at.y, at.z)));
  const auto difference = [&](const Vec3& along) {
    const Vec2 d = coordinates(p + step * along) - coordinates(p - step * along);
    return d - glm::round(d);
  };
  // How u and v change along a and b; its inverse is how a point goes with u and v.
  const Vec2 da = difference(a), db = difference(b);
  const double determinant = da.x * db.y - da.y * db.x;
  if (!(determinant != 0)) return std::nullopt;
  const double sign = determinant < 0 ? -1 : 1;
  return checked({sign * (db.y * a - da.y * b), sign * (da.x * b - db.x * a)});
}

}  // namespace trace
