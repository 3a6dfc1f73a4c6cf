// The quadratic formula in any kind of number.
#pragma once

#include <optional>

#include "precision/ray.hpp"

namespace trace::precision {

template <class T>
struct Roots {
  T first, second;  // (-h - root) / a and (-h + root) / a
};

// Of a t^2 + 2 h t + c = 0; none where the discriminant h^2 - a c is negative. That of the two which is a sum
// is formed as such, the other by c / a = their product (Press et al., "Numerical Recipes", section 5.6). The
// discriminant itself is the textbook's, and cancels: of an object of size 1 at distance s it has lost the
// s^2 part of its digits.
template <class T>
std::optional<Roots<T>> roots_of(T a, T h, T c) {
  const T discriminant = h * h - a * c;
  if (!(discriminant >= 0)) return std::nullopt;
  const T root = std::sqrt(discriminant);
  const T q = h > 0 ? -(h + root) : root - h;
  if (q == 0) return Roots<T>{q / a, q / a};  // both 0, or the ray lies in the surface: 0 / 0, never hit
  return h > 0 ? Roots<T>{q / a, c / q} : Roots<T>{c / q, q / a};
}

}  // namespace trace::precision
