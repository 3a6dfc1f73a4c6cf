// A matrix that stands for an exact one, with a bound of the difference.
#pragma once

#include "geometry/vector.hpp"

namespace trace {

// |value - exact| <= error in each entry. No bound is known where an entry of `error` is infinite or NaN.
struct BoundedMatrix {
  Mat4 value{1};
  Mat4 error{0};
};

Mat4 absolute(const Mat4& m);
bool is_finite(const Mat4& m);

// What rounding does to each entry of the product a b of these very matrices, in any order of its sums:
// gamma(n) |a| |b| for the n roundings that can happen to a term. Sums with 0 and products with a power of
// two are exact, so translations leave the rest of a matrix exact, and scaling by 2 all of it.
Mat4 product_rounding(const Mat4& a, const Mat4& b);

// The inverse of `m`, which is exact. Computed in long double (64 bits of mantissa and a range that no
// product of four doubles leaves), then rounded. Where there is none, or none that can be vouched for
// (condition beyond about 2^60), the error is infinite.
BoundedMatrix bounded_inverse(const Mat4& m);

// Whether `inverse` is one of `m` in the sense that matters: the error of each coordinate it gives for the
// points of the unit cube placed by `m` is below 2^-20 of what that coordinate is summed from.
bool reliable(const BoundedMatrix& inverse, const Mat4& m);

}  // namespace trace
