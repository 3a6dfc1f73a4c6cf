#include "geometry/square.hpp"

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_rays.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("the normal of a square faces the ray from either side") {
  const auto above = meet(Square{}, {0.1, 0.2, 3}, {0, 0, -1});
  REQUIRE(above);
  CHECK(above->t == 3);
  CHECK(above->normal == Vec3(0, 0, 1));
  const auto below = meet(Square{}, {0.1, 0.2, -3}, {0, 0, 1});
  REQUIRE(below);
  CHECK(below->t == 3);
  CHECK(below->normal == Vec3(0, 0, -1));
}

TEST_CASE("a square shows u = x + 1/2 and v = y + 1/2 from either side") {
  const double z = GENERATE(2.0, -2.0);
  const auto hit = meet(Square{}, {0.125, -0.25, z}, {0, 0, -z});
  REQUIRE(hit);
  CHECK(hit->uv == Vec2(0.625, 0.25));
}

TEST_CASE("edges and corners belong to a square, what is beyond them does not") {
  const double x = GENERATE(-0.5, 0.0, 0.5), y = GENERATE(-0.5, 0.5);
  CHECK(meet(Square{}, {x, y, 1}, {0, 0, -1}));
  CHECK_FALSE(meet(Square{}, {x, y * (1 + 1e-15), 1}, {0, 0, -1}));
  CHECK_FALSE(meet(Square{}, {y * (1 + 1e-15), x, 1}, {0, 0, -1}));
}

TEST_CASE("a square behind the ray, or in whose plane the ray runs, is missed") {
  CHECK_FALSE(meet(Square{}, {0, 0, 1}, {0, 0, 1}));
  CHECK_FALSE(meet(Square{}, {-2, 0, 0}, {1, 0, 0}));
  CHECK_FALSE(meet(Square{}, {-2, 0, 0.1}, {1, 0, 0}));
}

TEST_CASE("a square is hit however near it is, unless the origin may lie on it") {
  CHECK(meet(Square{}, {0, 0, 1e-300}, {0, 0, -1}));
  CHECK_FALSE(meet(Square{}, {0, 0, 0}, {0, 0, -1}));
  LocalHit hit;
  CHECK(Square{}.intersect({{0, 0, 2e-15}, {0, 0, -1}, 1e-15}, hit));
  CHECK_FALSE(Square{}.intersect({{0, 0, 1e-15}, {0, 0, -1}, 1e-15}, hit));
}

TEST_CASE("a square no further than the least t of the ray is missed") {
  LocalHit hit;
  CHECK_FALSE(Square{}.intersect({{0, 0, 0.25}, {0, 0, -1}, 0, 0.25}, hit));
  CHECK(Square{}.intersect({{0, 0, 0.25}, {0, 0, -1}, 0, 0.2}, hit));
}

TEST_CASE("the bounds of a square are 1e-8 thick either way") {
  CHECK(Square{}.bounds().min == Vec3(-0.5, -0.5, -1e-8));
  CHECK(Square{}.bounds().max == Vec3(0.5, 0.5, 1e-8));
}
