// Numbers of twice the precision of doubles, as sums of two: Dekker, "A Floating-Point Technique for
// Extending the Available Precision", Numerische Mathematik 18 (1971), with the exact sum of Knuth and the
// exact product by a fused multiply-add.
//
// An operation is off by less than 2^-100 of the sum of the sizes of what goes in (sum) or of the product.
#pragma once

#include <cmath>

namespace trace {

struct DoubleDouble {
  double high = 0, low = 0;  // their sum is the value, |low| at most half a unit in the last place of high

  double rounded() const { return high + low; }
};

// a + b
inline DoubleDouble exact_sum(double a, double b) {
  const double sum = a + b;
  const double of_b = sum - a, of_a = sum - of_b;
  return {sum, (a - of_a) + (b - of_b)};
}

// a b
inline DoubleDouble exact_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = exact_sum(a.high, b.high), low = exact_sum(a.low, b.low);
  const DoubleDouble sum = exact_sum(high.high, high.low + low.high);
  return exact_sum(sum.high, sum.low + low.low);
}

inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return a + DoubleDouble{-b.high, -b.low};
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = exact_product(a.high, b.high);
  return exact_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

}  // namespace trace
