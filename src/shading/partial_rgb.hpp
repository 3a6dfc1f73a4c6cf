// A colour or a factor of one, which may be undefined in some channels.
#pragma once

#include "geometry/vector.hpp"
#include "shading/channels.hpp"

namespace trace {

// Whether every component is finite, by one comparison: 0 times a number is 0, and times infinity or NaN is
// NaN.
inline bool all_finite(const Vec3& v) {
  const Vec3 zero = v * 0.0;
  return zero.x + zero.y + zero.z == 0;
}

// `value` holds numbers and infinities, never NaN: where arithmetic says nothing of a channel, it is in
// `undefined` and its value is 0. Undefined are nothing times infinity, infinity less infinity, a broken
// power of a negative number (transmittance.hpp), and whatever an undefined channel is multiplied with (even
// by 0) or added to. Such a channel is drawn black.
struct PartialRgb {
  Rgb value{0};
  Channels undefined;

  PartialRgb() = default;
  PartialRgb(const Rgb& v) : value(v) {}  // NOLINT: every colour is one; `v` has no NaN
  PartialRgb(const Rgb& v, Channels u) : value(v), undefined(u) {}

  // Whether every channel is a number.
  bool finite() const { return !undefined.any() && all_finite(value); }
};

// The rules above, channel by channel; for the operators, which are fast where all is finite.
PartialRgb product_by_rule(const PartialRgb& a, const PartialRgb& b);
PartialRgb sum_by_rule(const PartialRgb& a, const PartialRgb& b);

// Where no result is undefined these have the bits of the same operation on Rgb. A finite result of
// multiplying and adding plain numbers shows that no step of it was undefined, so a formula can be tried in
// Rgb first.
inline PartialRgb operator*(const PartialRgb& a, const PartialRgb& b) {
  const PartialRgb product(a.value * b.value, a.undefined | b.undefined);
  return product.finite() ? product : product_by_rule(a, b);
}
inline PartialRgb operator+(const PartialRgb& a, const PartialRgb& b) {
  const PartialRgb sum(a.value + b.value, a.undefined | b.undefined);
  return sum.finite() ? sum : sum_by_rule(a, b);
}
inline PartialRgb& operator+=(PartialRgb& a, const PartialRgb& b) {
  return a = a + b;
}

}  // namespace trace
