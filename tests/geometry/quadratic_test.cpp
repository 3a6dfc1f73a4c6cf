#include "geometry/quadratic.hpp"

#include <catch2/catch.hpp>

using namespace trace;

TEST_CASE("stable roots are those of the textbook, in its order") {
  // (t - 2)(t - 5) and (t + 2)(t + 5), (t - 2)(t + 5).
  const Roots ahead = stable_roots(1, -3.5, 10, 1.5), behind = stable_roots(1, 3.5, 10, 1.5),
              around = stable_roots(1, 1.5, -10, 3.5);
  CHECK(ahead.first == 2);
  CHECK(ahead.second == 5);
  CHECK(behind.first == -5);
  CHECK(behind.second == -2);
  CHECK(around.first == -5);
  CHECK(around.second == 2);
}

TEST_CASE("the small one of two stable roots keeps its digits") {
  // t^2 - 2e16 t + 1: the small root is 5e-17 (1 + 2.5e-33), the textbook gives 0.
  const double root = std::sqrt(1e32 - 1);
  CHECK(1e16 - root == 0);
  CHECK(stable_roots(1, -1e16, 1, root).first == 5e-17);
  CHECK(stable_roots(1, 1e16, 1, root).second == -5e-17);
}

TEST_CASE("without a square term one root is that of the linear equation, the other infinitely far") {
  // 2 h t + c = 0 with h = -2, c = 6: t = 3/2.
  const Roots roots = stable_roots(0, -2, 6, 2);
  CHECK(roots.first == 1.5);
  CHECK(std::isinf(roots.second));
}

TEST_CASE("a discriminant is told from zero only beyond its rounding") {
  CHECK(Discriminant{1, 4}.is_well_conditioned());
  CHECK(Discriminant{-1, 4}.is_well_conditioned());
  CHECK_FALSE(Discriminant{0x1p-17, 1}.is_well_conditioned());
  CHECK(Discriminant{-0x1p-17, 1}.is_decided());
  CHECK_FALSE(Discriminant{0x1p-51, 1}.is_decided());
  CHECK_FALSE(Discriminant{0, 0}.is_decided());
}

TEST_CASE("a ray that starts on a quadric goes inward where its cosine says so") {
  CHECK(leaves_inward(0.1, 1e-15, 0));
  CHECK_FALSE(leaves_inward(-0.1, 1e-15, 1));
}

TEST_CASE("of a ray that is tangent as far as can be told, the far root decides as the course does") {
  for (const double inward : {-1e-16, 0.0, 1e-16}) {
    CHECK(leaves_inward(inward, 1e-15, 1.1e-8));
    CHECK_FALSE(leaves_inward(inward, 1e-15, 0.9e-8));
    CHECK_FALSE(leaves_inward(inward, 1e-15, -1));
  }
}
