#include "geometry/square.hpp"

namespace trace {

bool Square::intersect(const Ray& ray, LocalHit& hit) const {
  if (ray.direction.z == 0 || std::abs(ray.origin.z) <= ray.origin_error) return false;
  const double t = -ray.origin.z / ray.direction.z;
  if (!(t > ray.least_t)) return false;
  const Vec3 p = ray.at(t);
  if (!(p.x >= -0.5 && p.x <= 0.5 && p.y >= -0.5 && p.y <= 0.5)) return false;
  hit.t = t;
  hit.normal = Vec3(0, 0, ray.direction.z > 0 ? -1 : 1);
  hit.uv = Vec2(p.x + 0.5, p.y + 0.5);
  return true;
}

double Square::distance(const Vec3& p) const {
  return std::abs(p.z);
}

}  // namespace trace
