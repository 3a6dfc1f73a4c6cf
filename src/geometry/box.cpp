#include "geometry/box.hpp"

#include <algorithm>

namespace trace {

bool Box::intersect(const Ray& ray, LocalHit& hit) const {
  double best = std::numeric_limits<double>::infinity();
  int best_face = -1;
  for (int face = 0; face < 6; ++face) {
    const int axis = face % 3;
    if (ray.direction[axis] == 0) continue;
    const double plane = face / 3 - 0.5;
    const double t = (plane - ray.origin[axis]) / ray.direction[axis];
    if (!(t > ray.least_t && t < best) || std::abs(plane - ray.origin[axis]) <= ray.origin_error) continue;
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    const double a = ray.origin[next] + t * ray.direction[next];
    const double b = ray.origin[last] + t * ray.direction[last];
    if (a >= -0.5 && a <= 0.5 && b >= -0.5 && b <= 0.5) {
      best = t;
      best_face = face;
    }
  }
  if (best_face < 0) return false;

  const int axis = best_face % 3;
  const int low = axis == 0 ? 1 : 0, high = axis == 2 ? 1 : 2;
  const bool min_face = best_face < 3;
  const Vec3 p = ray.at(best);
  hit.t = best;
  hit.normal = Vec3(0);
  hit.normal[axis] = min_face ? -1 : 1;
  hit.uv = Vec2(min_face ? 0.5 - p[low] : 0.5 + p[low], 0.5 + p[high]);
  return true;
}

double Box::distance(const Vec3& p, const Vec3& normal) const {
  for (int axis = 0; axis < 3; ++axis) {
    if (normal[axis] != 0) return std::abs(p[axis] - 0.5 * normal[axis]);
  }
  return 0;
}

}  // namespace trace
