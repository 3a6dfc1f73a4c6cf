#include "geometry/cone.hpp"

#include <algorithm>

namespace trace {
namespace {

constexpr double min_radius = 1e-4;  // the language's: keeps a pointed cone's tip from degenerating
constexpr double min_slope = 1e-3;   // the language's: a cone without slope is drawn with this one

}  // namespace

Cone::Cone(double bottom_radius, double top_radius, double height, bool capped)
    : bottom_radius_(std::max(std::abs(bottom_radius), min_radius)),
      top_radius_(std::max(std::abs(top_radius), min_radius)),
      height_(height),
      capped_(capped),
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

bool Cone::intersect(const Ray& ray, LocalHit& hit) const {
  const Vec3 &o = ray.origin, &d = ray.direction;
  const double slope2 = slope_ * slope_;
  const double above_apex = o.z + apex_offset_;
  const double a = d.x * d.x + d.y * d.y - slope2 * d.z * d.z;
  if (a == 0) return false;
  const double b = 2 * (o.x * d.x + o.y * d.y - slope2 * above_apex * d.z);
  const double c = o.x * o.x + o.y * o.y - slope2 * above_apex * above_apex;
  const double discriminant = b * b - 4 * a * c;
  if (!(discriminant > 0)) return false;
  const double root = std::sqrt(discriminant);
  const double r1 = (-b + root) / (2 * a), r2 = (-b - root) / (2 * a);

  const auto on_side = [&](double t) {
    const double z = o.z + t * d.z;
    return z >= 0 && z <= height_;
  };
  const bool good1 = on_side(r1), good2 = on_side(r2);
  double t = min_t;
  if (good1 && r1 > t) t = r1;
  if (good2 && ((good1 && r2 < t) || r2 > min_t)) t = r2;

  if (t > min_t) {
    const Vec3 p = ray.at(t);
    hit.normal = glm::normalize(Vec3(p.x, p.y, -2 * slope2 * (p.z + apex_offset_)));
    if (!capped_ && glm::dot(hit.normal, d) > 0) hit.normal = -hit.normal;
  }

  if (capped_) {
    // A cap counts only where it is nearer than the side, so a ray that meets caps alone misses.
    const auto try_cap = [&](double z, double radius, double facing) {
      const double cap_t = (z - o.z) / d.z;
      if (!(cap_t > min_t && cap_t < t)) return;
      const Vec3 p = ray.at(cap_t);
      if (!(p.x * p.x + p.y * p.y <= radius * radius)) return;
      t = cap_t;
      hit.normal = Vec3(0, 0, d.z > 0 ? -facing : facing);
    };
    try_cap(0, bottom_radius_, 1);
    try_cap(height_, top_radius_, -1);
  }
  if (!(t > min_t)) return false;
  hit.t = t;
  return true;
}

}  // namespace trace
