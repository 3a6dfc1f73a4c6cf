#include "geometry/plane.hpp"

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_rays.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("a plane is hit from both sides, with the normal towards the ray") {
  const Plane plane(Vec3(0, 0, 2), Vec3(0, 0, 7));
  const auto above = meet(plane, {1e6, -5, 6}, {0, 0, -1});
  REQUIRE(above);
  CHECK(above->t == 4);
  CHECK(above->normal == Vec3(0, 0, 1));
  const auto below = meet(plane, {0, 0, -1}, {0, 0, 1});
  REQUIRE(below);
  CHECK(below->t == 3);
  CHECK(below->normal == Vec3(0, 0, -1));
}

TEST_CASE("a ray away from a plane, along it or in it does not hit it") {
  const Plane plane(Vec3(0), Vec3(0, 1, 0));
  CHECK_FALSE(meet(plane, {0, 1, 0}, {0, 1, 0}));
  CHECK_FALSE(meet(plane, {0, 1, 0}, {1, 0, 0}));
  CHECK_FALSE(meet(plane, {3, 0, 4}, {1, 0, 0}));
  CHECK_FALSE(meet(plane, {3, 0, 4}, {0, 1, 0}));
}

TEST_CASE("a slanted plane is hit where its equation says") {
  const Plane plane(Vec3(1, 0, 0), Vec3(1, 1, 1));  // x + y + z = 1
  const auto hit = meet(plane, {0, 0, 0}, {1, 1, 1});
  REQUIRE(hit);
  CHECK(hit->t == about(1 / std::sqrt(3.0)));
  CHECK(hit->normal == near(-Vec3(1) / std::sqrt(3.0)));
}

TEST_CASE("the length of a plane's normal does not matter, however large or small") {
  const double length = GENERATE(1e-310, 1e-200, 1.0, 1e200, 1e308);
  const auto hit = meet(Plane(Vec3(0), Vec3(0, 0, length)), {0, 0, 3}, {0, 0, -1});
  REQUIRE(hit);
  CHECK(hit->t == 3);
}

TEST_CASE("a ray that leaves a plane, as far as its origin is known, does not hit it") {
  const Plane plane(Vec3(1, 2, 3), Vec3(1, -2, 0.5));
  const Vec3 n = glm::normalize(Vec3(1, -2, 0.5));
  LocalHit hit;
  CHECK_FALSE(plane.intersect({Vec3(1, 2, 3) + 1e-12 * n, -n, 1e-12}, hit));
  CHECK(plane.intersect({Vec3(1, 2, 3) + 1e-11 * n, -n, 1e-12}, hit));
}

TEST_CASE("a plane hit far away is a number, and no hit where it is none") {
  LocalHit hit;
  const Plane plane(Vec3(0), Vec3(0, 0, 1));
  REQUIRE(plane.intersect({{0, 0, 1}, glm::normalize(Vec3(1, 0, -1e-15))}, hit));
  CHECK(hit.t == Approx(1e15));
  CHECK_FALSE(plane.intersect({{0, 0, 1e10}, Vec3(1, 0, -1e-310)}, hit));
  CHECK_FALSE(plane.intersect({Vec3(std::nan("")), Vec3(0, 0, 1)}, hit));
}

TEST_CASE("a plane has no bounds, and none anywhere else") {
  CHECK(Plane(Vec3(0), Vec3(1, 0, 0)).bounds().unbounded());
  Mat4 place(1);
  place[0][0] = 0;
  const Bounds world = transformed(Plane(Vec3(0), Vec3(1, 0, 0)).bounds(), place);
  CHECK(world.unbounded());
  CHECK_FALSE(world.empty());
  CHECK(hits_bounds(world, {Vec3(1, 2, 3), Vec3(0, 1, 0)}));
  CHECK_FALSE(Bounds{}.unbounded());
}
