// Rays against single shapes.
#pragma once

#include <optional>

#include "geometry/ray.hpp"

namespace trace::test {

inline Ray ray(const Vec3& origin, const Vec3& direction) {
  return {origin, glm::normalize(direction)};
}

// What `shape` says of the ray; the direction is made a unit vector.
template <class Shape>
std::optional<LocalHit> meet(const Shape& shape, const Vec3& origin, const Vec3& direction) {
  LocalHit hit;
  if (!shape.intersect(ray(origin, direction), hit)) return std::nullopt;
  return hit;
}

}  // namespace trace::test
