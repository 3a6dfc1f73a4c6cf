// Ray against triangle: Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", JGT 2(1)
// 1997.
#pragma once

#include "geometry/ray.hpp"

namespace trace {

// Corner a and the edges to b and c, in the space of the mesh.
struct Triangle {
  Vec3 a, ab, ac;
};

struct TriangleHit {
  double t, u, v;  // u and v weigh the second and third corner
};

// Edges included, no tolerance. This very form, with its one division, decides which face of a shared edge is
// hit; others leave pinholes or pick the other face.
inline bool intersect(const Triangle& triangle, const Ray& ray, TriangleHit& hit) {
  const Vec3 p = glm::cross(ray.direction, triangle.ac);
  const double inverse = 1.0 / glm::dot(triangle.ab, p);
  const Vec3 from_a = ray.origin - triangle.a;
  hit.u = glm::dot(from_a, p) * inverse;
  if (!(hit.u >= 0 && hit.u <= 1)) return false;  // also where the ray is parallel: NaN or infinite
  const Vec3 q = glm::cross(from_a, triangle.ab);
  hit.v = glm::dot(ray.direction, q) * inverse;
  if (!(hit.v >= 0 && hit.u + hit.v <= 1)) return false;
  hit.t = glm::dot(triangle.ac, q) * inverse;
  return hit.t >= min_t;
}

// Unit normal, counter-clockwise corners facing the viewer. Not finite for a triangle without area.
inline Vec3 face_normal(const Triangle& triangle) {
  return glm::normalize(glm::cross(triangle.ab, triangle.ac));
}

}  // namespace trace
