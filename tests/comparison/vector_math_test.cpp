#include "comparison/perceptual/vector_math.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace trace;

TEST_CASE("the fast cube root is exact to 3e-7 over all that colours need") {
  for (float x = 0.008F; x < 1.1F; x *= 1.0003F)
    CHECK(std::abs(fast_cube_root(x) / std::cbrt(x) - 1) < 3e-7F);
}

TEST_CASE("the fast logarithm and power of 2 are exact to 3e-7") {
  for (float x = 1e-30F; x < 1e30F; x *= 1.37F)
    CHECK(std::abs(fast_log2(x) - std::log2(x)) <= 3e-7F * std::max(1.0F, std::abs(std::log2(x))));
  for (float x = -100; x < 100; x += 0.0931F)
    CHECK(std::abs(static_cast<double>(fast_exp2(x)) / std::exp2(static_cast<double>(x)) - 1) < 3e-7);
}

TEST_CASE("the fast power is exact where it is simple") {
  CHECK(fast_pow(1, 0.7F) == 1);
  CHECK(fast_pow(4, 0.5F) == Approx(2).epsilon(1e-6));
  CHECK(fast_pow(100, 0.7F) == Approx(25.118864).epsilon(1e-6));
}
