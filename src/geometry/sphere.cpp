#include "geometry/sphere.hpp"

namespace trace {

bool Sphere::intersect(const Ray& given, LocalHit& hit) const {
  const Ray ray{given.origin, glm::normalize(given.direction)};
  const Vec3 to_centre = -ray.origin;
  const double b = glm::dot(to_centre, ray.direction);
  const double discriminant = b * b - glm::dot(to_centre, to_centre) + 1;
  if (!(discriminant >= 0)) return false;
  const double root = std::sqrt(discriminant);
  const double far = b + root;
  if (far <= min_t) return false;
  const double near = b - root;
  hit.t = near > min_t ? near : far;
  hit.normal = glm::normalize(ray.at(hit.t));
  return true;
}

}  // namespace trace
