// Which way light goes on from a surface. `d` and `n` are of unit length; so is the result, to a few units in
// the last place, and it is not normalised again: the last bits of these forms, which split the direction
// along and across the normal, show in the course's pictures of cube maps.
#pragma once

#include <optional>

#include "geometry/vector.hpp"

namespace trace {

// V is a vector of three numbers, in doubles but where the arithmetic is compared (src/precision).
template <class V>
V mirrored_direction(const V& d, const V& n) {
  const V along = glm::dot(n, -d) * n;
  const V across = along + d;
  return along + across;
}

// Snell's law for n.d <= 0; `eta` is the index before the surface over that behind it. None: total internal
// reflection, or an index of 0 behind the surface, for which eta is infinite.
//
// k = 1 - |across|^2 decides. Near the critical angle its rounding error is below (2 |eta| + 10) 2^-53 to
// first order: across = eta w with w = d - (n.d) n has |w| = 1/eta there. The error of n.d lies along n,
// across which it changes no length; each component of (n.d) n and of w has one rounding, which in |across|^2
// weigh 2 |eta| and 2; then eta w adds 2 roundings, the sum of squares 3 and the difference 1. So only a ray
// whose true k is that small can be taken for the other kind. (1 - eta s)(1 + eta s) has the same error, that
// of the sine s: it would change bits and gain nothing. The length is 1 whatever the error of k, which the
// two parts share.
template <class V>
std::optional<V> refracted_direction(const V& d, const V& n, typename V::value_type eta) {
  if (!std::isfinite(eta)) return std::nullopt;
  const V across = eta * (d - glm::dot(n, d) * n);
  const auto k = 1 - glm::dot(across, across);
  if (k < 0) return std::nullopt;
  return across - std::sqrt(k) * n;
}

}  // namespace trace
