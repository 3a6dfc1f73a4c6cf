#include "scene/fog.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trace {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double coordinate(const Vec3& axis, const Ray& ray, double t) {
  if (t >= 0) return glm::dot(axis, ray.at(t));
  const double along = glm::dot(axis, ray.direction);
  return along == 0 ? glm::dot(axis, ray.origin) : std::copysign(infinity, along);
}

}  // namespace

double Fog::part(const Ray& ray, double t) const {
  const double depth = axis ? coordinate(*axis, ray, t) : (t >= 0 ? t : infinity);
  if (end) {
    if (std::isinf(depth)) return (depth > 0) == (*end > start) ? 1 : 0;
    return std::clamp((depth - start) / (*end - start), 0.0, 1.0);
  }
  if (density == 0 || !(depth > start)) return 0;
  return -std::expm1(-density * (depth - start));
}

}  // namespace trace
