// Length and direction of a vector of any size.
#pragma once

#include "geometry/vector.hpp"

namespace trace {

struct UnitVector {
  Vec3 direction;
  double length;
};

// Where the squares of the coordinates would leave the range of doubles.
UnitVector unit_vector_of_any_size(const Vec3& v);

// GLM's length and normalize, and so their bits, wherever the square of the length is far from overflow and
// underflow; otherwise the same of v times a power of two. The direction of a vector of zeros is NaN.
inline UnitVector unit_vector(const Vec3& v) {
  const double square = glm::dot(v, v);
  if (!(square > 0x1p-900 && square < 0x1p+900)) return unit_vector_of_any_size(v);
  const double length = std::sqrt(square);
  return {v * (1 / length), length};
}

}  // namespace trace
