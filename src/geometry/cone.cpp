#include "geometry/cone.hpp"

#include <algorithm>

#include "geometry/quadratic.hpp"
#include "geometry/rounding.hpp"
#include "geometry/texture_coordinates.hpp"

namespace trace {
namespace {

constexpr double min_radius = 1e-4;  // the language's: keeps a pointed cone's tip from degenerating
constexpr double min_slope = 1e-3;   // the language's: a cone without slope is drawn with this one

}  // namespace

Cone::Cone(double bottom_radius, double top_radius, double height, bool capped, Habits habits)
    : bottom_radius_(std::max(std::abs(bottom_radius), min_radius)),
      top_radius_(std::max(std::abs(top_radius), min_radius)),
      height_(height),
      capped_(capped),
      habits_(habits),
      slope_((top_radius_ - bottom_radius_) / height),
      apex_offset_(0) {
  if (std::abs(slope_) < min_slope) slope_ = min_slope;
  apex_offset_ = (slope_ < 0 ? top_radius_ : bottom_radius_) / slope_;
  if (apex_offset_ < 0) apex_offset_ -= height_;
}

Bounds Cone::bounds() const {
  const double radius = std::max(bottom_radius_, top_radius_);
  return {Vec3(-radius, -radius, std::min(height_, 0.0)), Vec3(radius, radius, std::max(height_, 0.0))};
}

// The roots are those of a t^2 + b t + c = 0; `from_apex` is the origin seen from the apex.
bool Cone::side_roots(const Ray& ray, const Vec3& from_apex, Roots& roots) const {
  const Vec3& d = ray.direction;
  const double slope2 = slope_ * slope_;
  const double a = d.x * d.x + d.y * d.y - slope2 * d.z * d.z;
  const double b = 2 * (from_apex.x * d.x + from_apex.y * d.y - slope2 * from_apex.z * d.z);
  const double reach2 = radius_squared(from_apex), cone2 = slope2 * from_apex.z * from_apex.z;
  const double c = reach2 - cone2;  // positive outside
  const double discriminant = b * b - 4 * a * c;
  // As the sphere's, with the gradient (x, y, -B^2 z) of c / 2.
  const double gradient = std::abs(from_apex.x) + std::abs(from_apex.y) + slope2 * std::abs(from_apex.z);
  const bool on_surface = std::abs(c) <= ray.origin_error * (2 * gradient + (2 + slope2) * ray.origin_error) +
                                             gamma(6) * (reach2 + cone2);
  // Along a generator the equation becomes linear, and near it one root is lost in -b + root.
  const bool linear = !(std::abs(4 * a * c) > 0x1p-12 * b * b);
  Discriminant stable{0, 0};
  const bool loses_a_root = linear && !(on_surface && a != 0);
  if (loses_a_root ||
      !Discriminant{discriminant, b * b + 4 * std::abs(a) * (reach2 + cone2)}.is_well_conditioned()) {
    // A quarter of it without cancellation for far origins: with the moment w = o x d about the apex, B^2
    // (wx^2 + wy^2) - wz^2 (Lagrange's identity for the form x^2 + y^2 - B^2 z^2).
    const Vec3 moment = accurate_cross(from_apex, d);
    const double across = slope2 * radius_squared(moment), along = moment.z * moment.z;
    stable = {across - along, across + along};
  }
  if (stable.is_decided()) {
    if (stable.value < 0) return false;
    roots = stable_roots(a, 0.5 * b, c, std::sqrt(stable.value));
  } else {
    if (!(discriminant > 0) || a == 0) return false;
    const double root = std::sqrt(discriminant);
    roots = {(-b - root) / (2 * a), (-b + root) / (2 * a)};
  }
  // A ray that starts on the surface does so at t = 0.
  if (on_surface) (std::abs(roots.first) < std::abs(roots.second) ? roots.first : roots.second) = 0;
  return true;
}

bool Cone::intersect(const Ray& ray, LocalHit& hit) const {
  const Vec3 &o = ray.origin, &d = ray.direction;
  const Vec3 from_apex(o.x, o.y, o.z + apex_offset_);
  Roots roots;
  if (!side_roots(ray, from_apex, roots)) {
    if (habits_ == Habits::course) return false;
    roots = {-1, -1};  // behind the ray: through the apex it may meet the caps alone
  }

  // A coordinate of a place on the ray is off by a few roundings of both its terms and of t. At the rim, side
  // and caps both count within that, so that no ray passes between them.
  const auto rounding = [&](double t, int axis) {
    return gamma(8) * (std::abs(o[axis]) + std::abs(t * d[axis]));
  };
  // The mirror image of the cone beyond its apex is never between z = 0 and z = height.
  const auto on_side = [&](double t) {
    const double z = o.z + t * d.z, slack = rounding(t, 2);
    return z >= -slack && z <= height_ + slack && slack <= height_;  // not where t is infinite
  };
  const double r1 = roots.second, r2 = roots.first;  // with + and - before the square root
  const bool good1 = on_side(r1), good2 = on_side(r2);
  const bool course = habits_ == Habits::course;
  const double none = course ? ray.least_t : std::numeric_limits<double>::infinity();
  double t = none;
  if (course) {
    if (good1 && r1 > t) t = r1;
    if (good2 && ((good1 && r2 < t) || r2 > ray.least_t)) t = r2;
  } else {
    if (good1 && r1 > ray.least_t) t = r1;
    if (good2 && r2 > ray.least_t && r2 < t) t = r2;
  }

  if (t != none && t > ray.least_t) {
    const Vec3 p = ray.at(t);
    hit.normal = glm::normalize(Vec3(p.x, p.y, (course ? -2 : -1) * slope_ * slope_ * (p.z + apex_offset_)));
    if (!capped_ && glm::dot(hit.normal, d) > 0) hit.normal = -hit.normal;
  }

  if (capped_) {
    // By the course's habits a cap counts only where it is nearer than the side, so a ray that meets caps
    // alone misses.
    const auto try_cap = [&](double z, double radius, double facing) {
      if (std::abs(z - o.z) <= ray.origin_error) return;
      const double cap_t = (z - o.z) / d.z;
      if (!(cap_t > ray.least_t && cap_t < t)) return;
      const Vec3 p = ray.at(cap_t);
      const double slack = 2 * (std::abs(p.x) * rounding(cap_t, 0) + std::abs(p.y) * rounding(cap_t, 1));
      if (!(radius_squared(p) <= radius * radius + slack)) return;
      t = cap_t;
      hit.normal = Vec3(0, 0, course && d.z > 0 ? -facing : facing);
    };
    try_cap(0, bottom_radius_, course ? 1 : -1);
    try_cap(height_, top_radius_, course ? -1 : 1);
  }
  if (t == none || !(t > ray.least_t)) return false;
  hit.t = t;
  return true;
}

double Cone::distance(const Vec3& p, const Vec3& normal) const {
  if (normal.x == 0 && normal.y == 0) return std::min(std::abs(p.z), std::abs(p.z - height_));
  return std::abs(std::sqrt(radius_squared(p)) - std::abs(slope_ * (p.z + apex_offset_)));
}

Vec2 Cone::texture_coordinates(const Vec3& p, const Vec3& normal) const {
  if (normal.x == 0 && normal.y == 0) {
    return across_disk(p, std::abs(p.z) < std::abs(p.z - height_) ? bottom_radius_ : top_radius_);
  }
  return {turn_around(p.x, p.y), in_unit(p.z / height_)};
}

}  // namespace trace
