#include "geometry/sphere.hpp"

#include "geometry/quadratic.hpp"
#include "geometry/rounding.hpp"
#include "geometry/texture_coordinates.hpp"

namespace trace {
namespace {

// Where the course's discriminant b^2 - o.o + 1 loses its digits, far away or near the rim. The same without
// cancellation is d.d - |o x d|^2 (Haines, Guenther, Akenine-Moeller, "Precision Improvements for Ray/Sphere
// Intersection", Ray Tracing Gems, ch. 7, with the cross product in place of the difference of vectors).
// False for no root; `roots` stay as they are where this form cannot tell either.
bool ask_stable_form(const Ray& ray, double b, double c, double discriminant, Roots& roots) {
  const Vec3 moment = accurate_cross(ray.origin, ray.direction);
  const double a = glm::dot(ray.direction, ray.direction), square = glm::dot(moment, moment);
  const Discriminant stable{a - square, a + square};
  if (!stable.is_decided()) return discriminant >= 0;
  if (stable.value < 0) return false;
  roots = stable_roots(a, -b, c, std::sqrt(stable.value));
  return true;
}

}  // namespace

bool Sphere::intersect(const Ray& given, LocalHit& hit) const {
  Ray ray = given;
  ray.direction = glm::normalize(given.direction);
  const Vec3 to_centre = -ray.origin;
  const double b = glm::dot(to_centre, ray.direction);
  const double square = glm::dot(to_centre, to_centre);
  const double discriminant = b * b - square + 1;
  const double c = square - 1;  // positive outside
  const bool is_good = Discriminant{discriminant, b * b + square + 1}.is_well_conditioned();
  if (is_good && discriminant < 0) return false;
  const double root = std::sqrt(discriminant);
  Roots roots{b - root, b + root};
  if (!is_good && !ask_stable_form(ray, b, c, discriminant, roots)) return false;
  // c changes by 2 |o| for a step along the normal, which next to the surface is 2; in each coordinate the
  // origin may be off by its error, so by sqrt(3) times as much along the normal. c itself is off by gamma(4)
  // (o.o + 1).
  const double unsure = 4 * ray.origin_error + 2 * gamma(4);
  if (c > unsure) {
    if (!(b > 0)) return false;
    hit.t = roots.first;
  } else {
    if (c >= -unsure && !leaves_inward(b, unsure, roots.second)) return false;
    hit.t = roots.second;
  }
  if (!(hit.t > ray.least_t)) return false;
  hit.normal = glm::normalize(ray.at(hit.t));
  return true;
}

double Sphere::distance(const Vec3& p) const {
  return std::abs(glm::length(p) - 1);
}

Vec2 Sphere::texture_coordinates(const Vec3& p, const Vec3&) const {
  return by_direction(p);
}

}  // namespace trace
