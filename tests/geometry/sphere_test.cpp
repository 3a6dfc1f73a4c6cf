#include "geometry/sphere.hpp"

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_rays.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("a sphere is hit at its near side from outside, with the normal outward") {
  const Vec3 axis =
      GENERATE(Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1));
  const auto hit = meet(Sphere{}, 5.0 * axis, -axis);
  REQUIRE(hit);
  CHECK(hit->t == 4);
  CHECK(hit->normal == near(axis));
}

TEST_CASE("a sphere off the axis is hit where Pythagoras says") {
  // At height 3/5 the sphere is met at x = 4/5.
  const auto hit = meet(Sphere{}, {5, 0.6, 0}, {-1, 0, 0});
  REQUIRE(hit);
  CHECK(hit->t == about(4.2));
  CHECK(hit->normal == near(0.8, 0.6, 0));
}

TEST_CASE("a sphere is hit at its far side from inside, with the normal still outward") {
  const auto hit = meet(Sphere{}, {0, 0, 0.25}, {0, 0, -1});
  REQUIRE(hit);
  CHECK(hit->t == 1.25);
  CHECK(hit->normal == near(0, 0, -1));
}

TEST_CASE("a sphere behind the ray or beside it is missed") {
  CHECK_FALSE(meet(Sphere{}, {0, 0, 5}, {0, 0, 1}));
  CHECK_FALSE(meet(Sphere{}, {1.000001, 0, 5}, {0, 0, -1}));
  CHECK_FALSE(meet(Sphere{}, {3, 3, 3}, {1, -1, 0}));
}

TEST_CASE("a ray that grazes a sphere hits it") {
  // b^2 - o.o + 1 = 25 - 26 + 1 = 0 without rounding.
  const auto hit = meet(Sphere{}, {1, 0, 5}, {0, 0, -1});
  REQUIRE(hit);
  CHECK(hit->t == 5);
  CHECK(hit->normal == near(1, 0, 0));
}

TEST_CASE("a ray that leaves a point of a sphere does not hit that point again") {
  CHECK_FALSE(meet(Sphere{}, {0, 0, 1}, {0, 0, 1}));
  const auto across = meet(Sphere{}, {0, 0, 1}, {0, 0, -1});
  REQUIRE(across);
  CHECK(across->t == 2);
}

TEST_CASE("a sphere is hit however near it is, unless the origin may lie on it") {
  const double near_by = GENERATE(1e-8, 1e-11, 1e-14);
  CHECK(meet(Sphere{}, {0, 0, 1 + near_by}, {0, 0, -1})->t < 2 * near_by);
  CHECK(meet(Sphere{}, {0, 0, 1 - near_by}, {0, 0, 1})->t < 2 * near_by);
  LocalHit hit;
  REQUIRE(Sphere{}.intersect({{0, 0, 1 + near_by}, {0, 0, -1}, near_by}, hit));
  CHECK(hit.t == about(2 + near_by));  // the far side is left
  CHECK_FALSE(Sphere{}.intersect({{0, 0, 1 - near_by}, {0, 0, 1}, near_by}, hit));
}

TEST_CASE("a ray along a chord of a sphere from its surface meets the other end however short the chord is") {
  const double angle = GENERATE(1e-3, 1e-6, 1e-9, 1e-12);
  const auto hit = meet(Sphere{}, {0, 0, 1}, {std::cos(angle), 0, -std::sin(angle)});
  REQUIRE(hit);
  const double chord = 2 * std::sin(angle);
  if (angle >= 1e-6) CHECK(hit->t == Approx(chord).epsilon(1e-3));
  // A chord that is less than half a unit in the last place deep may end anywhere in its second half.
  CHECK(hit->t >= 0.5 * chord * (1 - 1e-9));
  CHECK(hit->t <= chord * (1 + 1e-3));
}

TEST_CASE("a sphere has no texture coordinates") {
  CHECK(meet(Sphere{}, {0.3, 0.4, 5}, {0, 0, -1})->uv == Vec2(0, 0));
}
