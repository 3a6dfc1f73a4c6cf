// The cylinder in any kind of number; geometry/cylinder.hpp has the contract.
#pragma once

#include "geometry/cylinder.hpp"
#include "precision/quadratic.hpp"

namespace trace::precision {

template <class T>
bool meets_side(const Ray<T>& ray, LocalHit<T>& hit) {
  const Vec3<T>&o = ray.origin, &d = ray.direction;
  const T a = d.x * d.x + d.y * d.y;
  if (a == 0) return false;
  const auto roots = roots_of(a, o.x * d.x + o.y * d.y, o.x * o.x + o.y * o.y - 1);
  if (!roots) return false;
  for (const T t : {roots->first, roots->second}) {
    const Vec3<T> p = ray.at(t);
    if (!(t > ray.least_t && p.z >= 0 && p.z <= 1)) continue;
    hit.t = t;
    hit.normal = glm::normalize(Vec3<T>(p.x, p.y, 0));
    return true;
  }
  return false;
}

template <class T>
bool meets_caps(const Ray<T>& ray, LocalHit<T>& hit) {
  if (ray.direction.z == 0) return false;
  const int first = ray.direction.z > 0 ? 0 : 1;
  for (const int top : {first, 1 - first}) {
    const T t = (static_cast<T>(top) - ray.origin.z) / ray.direction.z;
    const Vec3<T> p = ray.at(t);
    if (!(t > ray.least_t && p.x * p.x + p.y * p.y <= 1)) continue;
    hit.t = t;
    hit.normal = Vec3<T>(0, 0, top == 1 ? 1 : -1);
    return true;
  }
  return false;
}

template <class T>
bool intersect(const Cylinder&, const Ray<T>& ray, LocalHit<T>& hit) {
  LocalHit<T> side;
  const bool on_side = meets_side(ray, side), on_cap = meets_caps(ray, hit);
  if (on_side && (!on_cap || side.t < hit.t)) hit = side;
  return on_side || on_cap;
}

template <class T>
T distance(const Cylinder&, const Vec3<T>& p, const Vec3<T>& normal) {
  if (normal.z != 0) return std::abs(p.z - (normal.z > 0 ? 1 : 0));
  return std::abs(std::sqrt(p.x * p.x + p.y * p.y) - 1);
}

}  // namespace trace::precision
