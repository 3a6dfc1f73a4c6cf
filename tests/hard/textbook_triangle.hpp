// Ray against triangle as textbooks have it, to be compared with.
#pragma once

#include "tests/hard/adapters.hpp"

namespace trace::hard {

// Moeller and Trumbore (1997) in double, as printed: a determinant within 1e-12 of zero is a parallel ray,
// hits count beyond 1e-8.
inline bool textbook_meets(const Corners& corner, const Ray& ray, double& t) {
  const Vec3 ab = corner.b - corner.a, ac = corner.c - corner.a;
  const Vec3 p = glm::cross(ray.direction, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant > -1e-12 && determinant < 1e-12) return false;
  const double inverse = 1 / determinant;
  const Vec3 from_a = ray.origin - corner.a;
  const double u = glm::dot(from_a, p) * inverse;
  if (u < 0 || u > 1) return false;
  const Vec3 q = glm::cross(from_a, ab);
  const double v = glm::dot(ray.direction, q) * inverse;
  if (v < 0 || u + v > 1) return false;
  t = glm::dot(ac, q) * inverse;
  return t > 1e-8;
}

inline void textbook_hits(const Mesh& mesh, const Ray& ray, std::vector<FaceHit>& hits) {
  hits.clear();
  double t = 0;
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    if (textbook_meets(mesh.corners(face), ray, t)) hits.push_back({face, t});
  }
}

}  // namespace trace::hard
