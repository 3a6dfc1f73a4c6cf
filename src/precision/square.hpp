// The unit square in any kind of number; geometry/square.hpp has the contract.
#pragma once

#include "geometry/square.hpp"
#include "precision/ray.hpp"

namespace trace::precision {

template <class T>
bool intersect(const Square&, const Ray<T>& ray, LocalHit<T>& hit) {
  if (ray.direction.z == 0) return false;
  hit.t = -ray.origin.z / ray.direction.z;
  if (!(hit.t > ray.least_t)) return false;
  const Vec3<T> p = ray.at(hit.t);
  const T half = T(0.5);
  if (!(p.x >= -half && p.x <= half && p.y >= -half && p.y <= half)) return false;
  hit.normal = Vec3<T>(0, 0, ray.direction.z > 0 ? -1 : 1);
  hit.uv = Vec2<T>(p.x + half, p.y + half);
  return true;
}

template <class T>
T distance(const Square&, const Vec3<T>& p, const Vec3<T>&) {
  return std::abs(p.z);
}

}  // namespace trace::precision
