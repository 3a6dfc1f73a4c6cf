#include "geometry/unit_vector.hpp"

#include "geometry/rounding.hpp"

namespace trace {

UnitVector unit_vector_of_any_size(const Vec3& v) {
  const double size = largest(v);
  if (!(size > 0) || !is_finite(v)) return {glm::normalize(v), glm::length(v)};
  int exponent = 0;
  std::frexp(size, &exponent);
  const Vec3 scaled(std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent));
  const double length = glm::length(scaled);  // 1/2 to sqrt(3)
  return {scaled * (1 / length), std::ldexp(length, exponent)};
}

}  // namespace trace
