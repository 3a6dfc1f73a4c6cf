#include "scene/beam.hpp"

#include <algorithm>
#include <numbers>

#include "geometry/rounding.hpp"

namespace trace {
namespace {

// A point of a surface is off by some 2^-48 of the numbers that it came from (Surface measures it, and finds
// up to 2^-44 for cylinders and cones). Within 2^-40 of the largest coordinate of the point and the light it
// is taken to be on an edge: a pixel of a picture is 2^-16 of what is seen.
constexpr double edge_of_largest = 0x1p-40;

}  // namespace

double smooth_step(double from, double to, double x) {
  if (x >= to) return 1;
  if (!(x > from)) return 0;
  const double t = (x - from) / (to - from);
  return t * t * (3 - 2 * t);
}

bool Flaps::let_through(const Vec3& p, double slack) const {
  if (!(p.y >= low.y - slack && p.y <= high.y + slack)) return false;
  if (outline == Outline::circle) {
    const Vec2 middle = (Vec2(low.x, low.z) + Vec2(high.x, high.z)) / 2.0;
    return glm::distance(Vec2(p.x, p.z), middle) <= glm::distance(Vec2(low.x, low.z), middle) + slack;
  }
  if (!(p.x >= low.x - slack && p.x <= high.x + slack && p.z >= low.z - slack && p.z <= high.z + slack)) {
    return false;
  }
  if (outline == Outline::box) return true;
  const Vec2 size(high.x - low.x, high.z - low.z);
  return (p.x - low.x) * size.y + (p.z - low.z) * size.x <= size.x * size.y + slack * (size.x + size.y);
}

Aperture::Aperture(int corners, bool star, double radius, const Vec3& x, const Vec3& up)
    : x_(x), up_(up), radius_(radius), star_(star) {
  if (corners == 0) return;
  const double part = std::numbers::pi / corners;
  apothem_ = radius * std::cos(part);
  for (int k = 0; k < corners; ++k) {
    const double from_up = (2 * k + 1) * part;
    outward_.emplace_back(std::sin(from_up), std::cos(from_up));
  }
}

Aperture Aperture::square(double half, const Vec3& x, const Vec3& up) {
  const double diagonal = std::numbers::sqrt2 / 2;
  Aperture result(4, false, half / diagonal, diagonal * (x + up), diagonal * (up - x));
  result.apothem_ = half;
  return result;
}

bool Aperture::holds(const Vec2& p, double slack) const {
  return std::all_of(outward_.begin(), outward_.end(),
                     [&](const Vec2& n) { return glm::dot(n, p) <= apothem_ + slack; });
}

bool Aperture::lets_through(const Vec3& across, double slack) const {
  const Vec2 p(glm::dot(across, x_), glm::dot(across, up_));
  if (outward_.empty()) return glm::length(p) <= radius_ + slack;
  return holds(p, slack) || (star_ && holds(-p, slack));
}

bool Beam::limits_anything() const {
  return !is_zero(direction) || reach < std::numeric_limits<double>::infinity() || flaps || aperture;
}

double Beam::share(const Vec3& position, const Vec3& point, const Vec3& towards, double distance) const {
  double result = 1;
  if (!is_zero(direction)) {
    const double cosine = -glm::dot(towards, direction);
    if (cosine_of_edge > -1) result *= smooth_step(cosine_of_edge, cosine_of_full, cosine);
    if (exponent > 0) result *= std::pow(std::max(0.0, cosine), exponent);
  }
  if (!(result > 0) || !(distance < reach)) return 0;
  if (reach < std::numeric_limits<double>::infinity()) {
    const double left = 1 - distance / reach;
    result *= left * left;
  }
  const double slack = edge_of_largest * std::max(largest(point), largest(position));
  if (flaps && !flaps->let_through(point, slack)) return 0;
  if (aperture) {
    const Vec3 offset = point - position;
    const double ahead = glm::dot(offset, direction);
    Vec3 across = offset - ahead * direction;
    double slack_there = slack;
    if (aperture_distance > 0) {
      if (!(ahead > 0)) return 0;
      across *= aperture_distance / ahead;
      slack_there *= aperture_distance / ahead;
    }
    if (!aperture->lets_through(across, slack_there)) return 0;
  }
  return result;
}

}  // namespace trace
