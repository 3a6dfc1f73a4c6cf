// What rounding does to sums and products of doubles.
//
// u = 2^-53 is the largest relative error of one rounding; n of them in a row are off by at most gamma(n) = n
// u / (1 - n u) (Higham, "Accuracy and Stability of Numerical Algorithms", 2nd ed., lemma 3.1).
#pragma once

#include "geometry/vector.hpp"

namespace trace {

inline constexpr double unit_roundoff = 0x1p-53;

constexpr double gamma(int n) {
  return n * unit_roundoff / (1 - n * unit_roundoff);
}

// a b - c d, off by at most 3/2 units in the last place: Kahan's form (Jeannerod, Louvet, Muller, "Further
// Analysis of Kahan's Algorithm for the Accurate Computation of 2 x 2 Determinants", Math. Comp. 82, 2013).
inline double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  return std::fma(a, b, -cd) + std::fma(-c, d, cd);
}

inline Vec3 accurate_cross(const Vec3& a, const Vec3& b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

// The largest coordinate without sign.
inline double largest(const Vec3& v) {
  const double x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
  const double xy = x > y ? x : y;
  return xy > z ? xy : z;
}

inline double sum_of_sizes(const Vec3& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

}  // namespace trace
