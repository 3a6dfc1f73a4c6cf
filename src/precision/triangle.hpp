// Ray against triangle in any kind of number.
#pragma once

#include "precision/ray.hpp"

namespace trace::precision {

template <class T>
struct Triangle {
  Vec3<T> a, ab, ac;  // a corner and the edges from it

  Triangle(const Vec3<T>& corner, const Vec3<T>& b, const Vec3<T>& c)
      : a(corner), ab(b - corner), ac(c - corner) {}

  // Unit length, to where the corners run counter-clockwise; not finite without area.
  Vec3<T> normal() const { return glm::normalize(glm::cross(ab, ac)); }
};

// Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", JGT 2(1) 1997, edges included, as
// docs/language.md writes it. What rounding decides is left to it: between two triangles a ray may pass.
template <class T>
bool intersect(const Triangle<T>& triangle, const Ray<T>& ray, LocalHit<T>& hit) {
  const Vec3<T> p = glm::cross(ray.direction, triangle.ac);
  const T inverse = 1 / glm::dot(triangle.ab, p);
  const Vec3<T> from_a = ray.origin - triangle.a;
  const T u = glm::dot(from_a, p) * inverse;
  if (!(u >= 0 && u <= 1)) return false;
  const Vec3<T> q = glm::cross(from_a, triangle.ab);
  const T v = glm::dot(ray.direction, q) * inverse;
  if (!(v >= 0 && u + v <= 1)) return false;
  hit.t = glm::dot(triangle.ac, q) * inverse;
  hit.uv = Vec2<T>(u, v);
  return hit.t > ray.least_t;
}

}  // namespace trace::precision
