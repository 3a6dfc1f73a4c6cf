// Numbers of 113 binary digits: what doubles are judged by.
//
// Doubles are exact in them, and so is a product of two.
#pragma once

#include <cmath>

namespace trace::test {

__extension__ typedef __float128 Quad;

inline Quad magnitude(Quad x) {
  return x < 0 ? -x : x;
}

// Newton's step from the root in double doubles its 53 digits; a second one clears what is left. For x that
// a double can hold; NaN for NaN and for what is negative.
inline Quad root(Quad x) {
  const double guess = std::sqrt(static_cast<double>(x));
  if (guess == 0) return 0;
  Quad r = guess;
  for (int step = 0; step < 2; ++step) r = (r + x / r) / 2;
  return r;
}

}  // namespace trace::test
