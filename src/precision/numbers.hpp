// Vectors in any kind of number, and how it rounds.
#pragma once

#include <cmath>
#include <limits>

#include "geometry/vector.hpp"

namespace trace::precision {

template <class T>
using Vec2 = glm::vec<2, T, glm::defaultp>;
template <class T>
using Vec3 = glm::vec<3, T, glm::defaultp>;
template <class T>
using Vec4 = glm::vec<4, T, glm::defaultp>;
template <class T>
using Mat4 = glm::mat<4, 4, T, glm::defaultp>;

// The largest relative error u of one rounding: 2^-24, 2^-53 or 2^-64. (geometry/rounding.hpp has the
// double's, and what many in a row amount to.)
template <class T>
inline constexpr T unit_roundoff = std::numeric_limits<T>::epsilon() / 2;

// Its square root, by Newton's method upwards of it; where a small error of a square shows in the root.
template <class T>
constexpr T root_of_roundoff() {
  T root = 1;
  for (int i = 0; i < 64; ++i) root = (root + unit_roundoff<T> / root) / 2;
  return root;
}

template <class T>
bool is_finite(const Vec3<T>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

template <class T>
bool is_zero(const Vec3<T>& v) {
  return v.x == 0 && v.y == 0 && v.z == 0;
}

}  // namespace trace::precision
