// The sphere as textbooks solve it, to compare with: discriminant b^2 - 4ac, roots (-b -+ w) / 2a, and hits
// from 1e-8 on.
#pragma once

#include "geometry/ray.hpp"

namespace trace::hard {

inline constexpr double textbook_least_t = 1e-8;

inline bool textbook_sphere(const Ray& ray, double& t) {
  const Vec3 &o = ray.origin, &d = ray.direction;
  const double a = glm::dot(d, d), b = 2 * glm::dot(o, d), c = glm::dot(o, o) - 1;
  const double discriminant = b * b - 4 * a * c;
  if (!(discriminant >= 0)) return false;
  const double near = (-b - std::sqrt(discriminant)) / (2 * a),
               far = (-b + std::sqrt(discriminant)) / (2 * a);
  if (far <= textbook_least_t) return false;
  t = near > textbook_least_t ? near : far;
  return true;
}

}  // namespace trace::hard
