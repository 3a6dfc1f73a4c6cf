// Vectors, matrices and colours: GLM in double precision, column vectors.
//
// The order of GLM's operations is part of the picture: dot sums from left to right, a matrix times a vector
// is (m0 x + m1 y) + (m2 z + m3 w), normalize multiplies by 1/sqrt(v.v). docs/language.md section 13.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace trace {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using Mat3 = glm::dmat3;
using Mat4 = glm::dmat4;

// Linear red, green, blue; not limited to [0, 1].
using Rgb = glm::dvec3;

inline bool is_finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline bool is_zero(const Rgb& c) {
  return c.x == 0 && c.y == 0 && c.z == 0;
}

}  // namespace trace
