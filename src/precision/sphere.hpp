// The unit sphere in any kind of number; geometry/sphere.hpp has the contract.
#pragma once

#include "geometry/sphere.hpp"
#include "precision/quadratic.hpp"

namespace trace::precision {

template <class T>
bool intersect(const Sphere&, const Ray<T>& ray, LocalHit<T>& hit) {
  const T h = glm::dot(ray.origin, ray.direction), c = glm::dot(ray.origin, ray.origin) - 1;
  const auto roots = roots_of(glm::dot(ray.direction, ray.direction), h, c);
  if (!roots) return false;
  hit.t = roots->first > ray.least_t ? roots->first : roots->second;
  if (!(hit.t > ray.least_t)) return false;
  hit.normal = glm::normalize(ray.at(hit.t));
  return true;
}

// Of a point from the surface that was hit.
template <class T>
T distance(const Sphere&, const Vec3<T>& p, const Vec3<T>&) {
  return std::abs(glm::length(p) - 1);
}

}  // namespace trace::precision
