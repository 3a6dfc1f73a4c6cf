// Numbers without any sense: garbage geometry must not upset the search.
#pragma once

#include <bit>

#include "tests/hard/aimed_rays.hpp"

namespace trace::hard {

// Any finite double, each pattern of bits as likely as the next.
inline double random_bits(Random& random) {
  for (;;) {
    const std::uint64_t high = random.below(1u << 31), low = random.below(1u << 31), sign = random.below(4);
    const auto x = std::bit_cast<double>(sign << 62 | high << 31 | low);
    if (std::isfinite(x)) return x;
  }
}

// As above, but of moderate size where `largest` is less than 1023: the exponent is within `largest` of zero.
inline double random_bits(Random& random, int largest) {
  const double x = fraction(random) - 0.5;
  return std::ldexp(x, static_cast<int>(random.below(static_cast<std::uint32_t>(2 * largest + 1))) - largest);
}

}  // namespace trace::hard
