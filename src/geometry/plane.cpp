#include "geometry/plane.hpp"

#include "geometry/texture_coordinates.hpp"

namespace trace {

// Scaled by a power of two first, so that no length overflows or vanishes.
Plane::Plane(const Vec3& point, const Vec3& normal) : point_(point) {
  int exponent = 0;
  (void)std::frexp(largest(normal), &exponent);
  const Vec3 n(std::ldexp(normal.x, -exponent), std::ldexp(normal.y, -exponent),
               std::ldexp(normal.z, -exponent));
  normal_ = glm::normalize(n);
}

// n . (p - q): a difference, a product and two sums for each term, so at most four roundings of each.
Plane::Height Plane::height(const Vec3& p, double error) const {
  const Vec3 size = glm::abs(normal_), from = p - point_;
  return {glm::dot(normal_, from),
          gamma(5) * glm::dot(size, glm::abs(from)) + error * (size.x + size.y + size.z) * (1 + gamma(4))};
}

bool Plane::intersect(const Ray& ray, LocalHit& hit) const {
  const double cosine = glm::dot(normal_, ray.direction);
  const Height above = height(ray.origin, ray.origin_error);
  if (cosine == 0 || std::abs(above.value) <= above.unsure) return false;
  const double t = -above.value / cosine;
  if (!(t > ray.least_t && t < std::numeric_limits<double>::infinity())) return false;
  hit.t = t;
  hit.normal = cosine > 0 ? -normal_ : normal_;
  return true;
}

double Plane::distance(const Vec3& p, const Vec3&) const {
  const Height above = height(p, 0);
  return std::abs(above.value) + above.unsure;
}

Vec2 Plane::texture_coordinates(const Vec3& p, const Vec3&) const {
  const Vec3 level(normal_.z, 0, -normal_.x);  // +y x normal
  const Vec3 right = is_zero(level) ? Vec3(1, 0, 0) : glm::normalize(level);
  const Vec3 up = glm::cross(normal_, right), from = p - point_;
  const double u = glm::dot(right, from), v = glm::dot(up, from);
  return {in_unit(u - std::floor(u)), in_unit(v - std::floor(v))};
}

}  // namespace trace
