#include "geometry/cylinder.hpp"

#include <initializer_list>

namespace trace {

bool Cylinder::intersect(const Ray& ray, LocalHit& hit) const {
  LocalHit side;
  const bool on_side = intersect_side(ray, side);
  const bool on_cap = intersect_caps(ray, hit);
  if (on_side && (!on_cap || side.t < hit.t)) hit = side;
  return on_side || on_cap;
}

bool Cylinder::intersect_side(const Ray& ray, LocalHit& hit) const {
  const Vec3 &o = ray.origin, &d = ray.direction;
  const double a = d.x * d.x + d.y * d.y;
  if (a == 0) return false;
  const double b = 2.0 * (o.x * d.x + o.y * d.y);
  const double c = o.x * o.x + o.y * o.y - 1.0;
  const double discriminant = b * b - 4.0 * a * c;
  if (!(discriminant >= 0)) return false;
  const double root = std::sqrt(discriminant);
  const double near = (-b - root) / (2.0 * a), far = (-b + root) / (2.0 * a);
  if (!(far > min_t)) return false;
  for (const double t : {near, far}) {
    if (!(t > min_t)) continue;
    const Vec3 p = ray.at(t);
    if (p.z >= 0 && p.z <= 1) {
      hit.t = t;
      hit.normal = glm::normalize(Vec3(p.x, p.y, 0));
      return true;
    }
  }
  return false;
}

bool Cylinder::intersect_caps(const Ray& ray, LocalHit& hit) const {
  if (ray.direction.z == 0) return false;
  const double bottom = -ray.origin.z / ray.direction.z;
  const double top = (1.0 - ray.origin.z) / ray.direction.z;
  const bool upward = ray.direction.z > 0;
  const double enter = upward ? bottom : top, leave = upward ? top : bottom;
  if (!(leave >= min_t)) return false;

  const auto inside_rim = [&](double t) {
    const Vec3 p = ray.at(t);
    return p.x * p.x + p.y * p.y <= 1.0;
  };
  if (enter >= min_t && inside_rim(enter)) {
    hit.t = enter;
    hit.normal = Vec3(0, 0, upward ? -1 : 1);
    return true;
  }
  if (inside_rim(leave)) {
    hit.t = leave;
    hit.normal = Vec3(0, 0, upward ? 1 : -1);
    return true;
  }
  return false;
}

}  // namespace trace
