#include "geometry/cylinder.hpp"

#include <algorithm>

#include "geometry/quadratic.hpp"
#include "geometry/rounding.hpp"
#include "geometry/texture_coordinates.hpp"

namespace trace {
namespace {

// a t^2 + b t + c = 0 with a = dx^2 + dy^2: where a ray meets the endless cylinder.
bool roots_of_side(const Ray& ray, double a, double c, Roots& roots) {
  const Vec3 &o = ray.origin, &d = ray.direction;
  const double b = 2.0 * (o.x * d.x + o.y * d.y);
  const double discriminant = b * b - 4.0 * a * c;
  Discriminant stable{0, 0};
  if (!Discriminant{discriminant, b * b + 4.0 * a * (c + 2)}.is_well_conditioned()) {
    // A quarter of it without cancellation for far origins.
    const double moment = difference_of_products(o.x, d.y, o.y, d.x);
    stable = {a - moment * moment, a + moment * moment};
  }
  if (stable.is_decided()) {
    if (stable.value < 0) return false;
    roots = stable_roots(a, 0.5 * b, c, std::sqrt(stable.value));
  } else {
    if (!(discriminant >= 0)) return false;
    const double root = std::sqrt(discriminant);
    roots = {(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)};
  }
  return true;
}

// Normals point outward. Rays along the axis have no hit here.
bool intersect_side(const Ray& ray, LocalHit& hit) {
  const double a = radius_squared(ray.direction);
  if (a == 0) return false;
  const double c = radius_squared(ray.origin) - 1.0;  // positive outside
  Roots roots;
  if (!roots_of_side(ray, a, c, roots)) return false;
  // As for the sphere.
  const double unsure = 4 * ray.origin_error + 2 * gamma(4);
  const double b = -(ray.origin.x * ray.direction.x + ray.origin.y * ray.direction.y);  // positive inward
  const auto meets = [&](double t) {
    if (!(t > ray.least_t)) return false;
    const Vec3 p = ray.at(t);
    if (!(p.z >= 0 && p.z <= 1)) return false;
    hit.t = t;
    hit.normal = glm::normalize(Vec3(p.x, p.y, 0));
    return true;
  };
  if (c > unsure) return b > 0 && (meets(roots.first) || meets(roots.second));
  return (c < -unsure || leaves_inward(b, unsure, roots.second)) && meets(roots.second);
}

}  // namespace

bool Cylinder::intersect(const Ray& ray, LocalHit& hit) const {
  LocalHit side;
  const bool on_side = intersect_side(ray, side);
  const bool on_cap = intersect_caps(ray, hit);
  if (on_side && (!on_cap || side.t < hit.t)) hit = side;
  const bool found = on_side || on_cap;
  if (found && !(glm::dot(hit.normal, ray.direction) > 0)) return true;
  return intersect_across_rim(ray, found, hit) || found;
}

// At the rim, rounding can put the hit on the side beyond the cap and the hit on the cap beyond the side.
bool Cylinder::intersect_across_rim(const Ray& ray, bool leaves, LocalHit& hit) const {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const Vec3 &o = ray.origin, &d = ray.direction;
  const double a = radius_squared(d), c = radius_squared(o) - 1.0;
  Roots side{-inf, inf}, caps{-inf, inf};
  if (a == 0 ? c > 0 : !roots_of_side(ray, a, c, side)) return false;
  if (d.z == 0) {
    if (o.z < 0 || o.z > 1) return false;
  } else {
    const double bottom = -o.z / d.z, top = (1.0 - o.z) / d.z;
    caps = {std::min(bottom, top), std::max(bottom, top)};
  }
  const double enter = std::max(side.first, caps.first), leave = std::min(side.second, caps.second);
  // The roots are within 2^-35 of the size (quadratic.hpp); beyond, the ray certainly crosses the cylinder.
  if (!(leave - enter > 0x1p-30 * (std::abs(enter) + std::abs(leave)))) return false;
  const double unsure = 4 * ray.origin_error + 2 * gamma(4);
  const auto meets = [&](double t, bool on_cap, bool upward_cap) {
    if (!(t > ray.least_t)) return false;
    if (on_cap ? std::abs(o.z - upward_cap) <= ray.origin_error : std::abs(c) <= unsure) return false;
    const Vec3 p = ray.at(t);
    hit.t = t;
    hit.normal = on_cap ? Vec3(0, 0, upward_cap ? 1 : -1) : glm::normalize(Vec3(p.x, p.y, 0));
    hit.is_gap = true;
    return true;
  };
  const bool upward = d.z > 0;
  return meets(enter, caps.first > side.first, !upward) ||
         (!leaves && meets(leave, caps.second < side.second, upward));
}

bool Cylinder::intersect_caps(const Ray& ray, LocalHit& hit) const {
  if (ray.direction.z == 0) return false;
  const double bottom = -ray.origin.z / ray.direction.z;
  const double top = (1.0 - ray.origin.z) / ray.direction.z;
  const bool upward = ray.direction.z > 0;
  const auto meets = [&](bool is_top) {
    const double t = is_top ? top : bottom;
    if (std::abs(ray.origin.z - is_top) <= ray.origin_error || !(t > ray.least_t)) return false;
    if (!(radius_squared(ray.at(t)) <= 1.0)) return false;
    hit.t = t;
    hit.normal = Vec3(0, 0, is_top ? 1 : -1);
    return true;
  };
  // The cap where the ray comes in, then the one where it leaves.
  return meets(!upward) || meets(upward);
}

double Cylinder::distance(const Vec3& p, const Vec3& normal) const {
  if (normal.z != 0) return std::abs(p.z - (normal.z > 0));
  return std::abs(std::sqrt(radius_squared(p)) - 1);
}

Vec2 Cylinder::texture_coordinates(const Vec3& p, const Vec3& normal) const {
  if (normal.z != 0) return across_disk(p, 1);
  return {turn_around(p.x, p.y), in_unit(p.z)};
}

bool Tube::intersect(const Ray& ray, LocalHit& hit) const {
  if (!intersect_side(ray, hit)) return false;
  if (glm::dot(hit.normal, ray.direction) > 0) hit.normal = -hit.normal;
  return true;
}

}  // namespace trace
