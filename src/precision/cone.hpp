// The cone in any kind of number, with the course's habits; geometry/cone.hpp has the contract.
#pragma once

#include "geometry/cone.hpp"
#include "precision/quadratic.hpp"

namespace trace::precision {

// Its radii and height are the scene's; what follows of them is computed in T.
template <class T>
struct ConeIn {
  T bottom_radius, top_radius, height, slope, apex_offset;
  bool capped;

  explicit ConeIn(const Cone& cone)
      : bottom_radius(static_cast<T>(cone.bottom_radius())),
        top_radius(static_cast<T>(cone.top_radius())),
        height(static_cast<T>(cone.height())),
        slope((top_radius - bottom_radius) / height),
        capped(cone.capped()) {
    if (std::abs(cone.slope()) == least_slope) slope = static_cast<T>(cone.slope());
    apex_offset = (slope < 0 ? top_radius : bottom_radius) / slope;
    if (apex_offset < 0) apex_offset -= height;
  }

 private:
  static constexpr double least_slope = 1e-3;  // that of a cone without slope
};

template <class T>
bool intersect(const ConeIn<T>& cone, const Ray<T>& ray, LocalHit<T>& hit) {
  const Vec3<T>&o = ray.origin, &d = ray.direction;
  const T slope2 = cone.slope * cone.slope, z = o.z + cone.apex_offset;
  const auto roots =
      roots_of(d.x * d.x + d.y * d.y - slope2 * d.z * d.z, o.x * d.x + o.y * d.y - slope2 * z * d.z,
               o.x * o.x + o.y * o.y - slope2 * z * z);
  if (!roots) return false;
  const auto on_side = [&](T t) {
    const T at = o.z + t * d.z;
    return at >= 0 && at <= cone.height;
  };
  const T r1 = roots->second, r2 = roots->first;
  const bool good1 = on_side(r1), good2 = on_side(r2);
  T t = ray.least_t;
  if (good1 && r1 > t) t = r1;
  if (good2 && ((good1 && r2 < t) || r2 > ray.least_t)) t = r2;
  if (t > ray.least_t) {
    const Vec3<T> p = ray.at(t);
    hit.normal = glm::normalize(Vec3<T>(p.x, p.y, -2 * slope2 * (p.z + cone.apex_offset)));
    if (!cone.capped && glm::dot(hit.normal, d) > 0) hit.normal = -hit.normal;
  }
  const auto try_cap = [&](T height, T radius, T facing) {
    const T cap_t = (height - o.z) / d.z;
    if (!(cap_t > ray.least_t && cap_t < t)) return;
    const Vec3<T> p = ray.at(cap_t);
    if (!(p.x * p.x + p.y * p.y <= radius * radius)) return;
    t = cap_t;
    hit.normal = Vec3<T>(0, 0, d.z > 0 ? -facing : facing);
  };
  if (cone.capped) {
    try_cap(0, cone.bottom_radius, 1);
    try_cap(cone.height, cone.top_radius, -1);
  }
  hit.t = t;
  return t > ray.least_t;
}

template <class T>
T distance(const ConeIn<T>& cone, const Vec3<T>& p, const Vec3<T>& normal) {
  if (normal.x == 0 && normal.y == 0) return std::min(std::abs(p.z), std::abs(p.z - cone.height));
  return std::abs(std::sqrt(p.x * p.x + p.y * p.y) - std::abs(cone.slope * (p.z + cone.apex_offset)));
}

// At right angles to the surface where a hit has `normal`, which on the side has twice the z part.
template <class T>
Vec3<T> facing(const Vec3<T>& normal) {
  const bool on_side = normal.x != 0 || normal.y != 0;
  return on_side ? glm::normalize(Vec3<T>(normal.x, normal.y, normal.z / 2)) : normal;
}

}  // namespace trace::precision
