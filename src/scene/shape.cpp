#include "scene/shape.hpp"

namespace trace {

bool intersect(const Shape& shape, const Ray& ray, LocalHit& hit) {
  return std::visit(
      [&](const auto& s) {
        if constexpr (requires { s.intersect(ray, hit); }) return s.intersect(ray, hit);
        return false;
      },
      shape);
}

double distance_with_rounding(const Shape& shape, const Vec3& p, const Vec3& normal) {
  return std::visit(
      [&](const auto& s) -> double {
        if constexpr (requires { s.distance(p); }) return s.distance(p) + gamma(4);
        if constexpr (requires { s.distance(p, normal); }) {
          return s.distance(p, normal) + gamma(4) * (1 + largest(p));
        }
        return 0;
      },
      shape);
}

Vec2 texture_coordinates(const Shape& shape, const LocalHit& hit, const Vec3& p) {
  return std::visit(
      [&](const auto& s) {
        if constexpr (requires { s.texture_coordinates(p, hit.normal); }) {
          return s.texture_coordinates(p, hit.normal);
        } else {
          return hit.uv;
        }
      },
      shape);
}

}  // namespace trace
