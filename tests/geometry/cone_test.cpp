// The cone is drawn with the habits of the course's renderer (docs/language.md section 5); the numbers here
// come from its formulas by hand. Most tests use bottom radius 1, top radius 2, height 1: then B = (2-1)/1 =
// 1, g = 1/B = 1, so the side is x^2 + y^2 = (z + 1)^2.
#include "geometry/cone.hpp"

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_rays.hpp"

using namespace trace;
using namespace trace::test;

namespace {

const Cone funnel(1, 2, 1, true);
const Cone open_funnel(1, 2, 1, false);

}  // namespace

TEST_CASE("the side of a cone is hit where its radius is, with the z part of the normal twice too large") {
  // Radius 1.5 at z = 0.5; n = (1.5, 0, -2 * 1.5), normalised.
  const auto hit = meet(funnel, {5, 0, 0.5}, {-1, 0, 0});
  REQUIRE(hit);
  CHECK(hit->t == about(3.5));
  CHECK(hit->normal == near(1 / std::sqrt(5), 0, -2 / std::sqrt(5)));
}

TEST_CASE("a pointed cone has a tip of radius 1e-4") {
  const Cone cone(1, 0, 1, true);
  CHECK(meet(cone, {5, 0, 1}, {-1, 0, 0})->t == about(5 - 1e-4));
  CHECK(meet(cone, {5, 0, 0}, {-1, 0, 0})->t == about(4));
  // Halfway up: (1 + 1e-4) / 2.
  CHECK(meet(cone, {5, 0, 0.5}, {-1, 0, 0})->t == about(5 - 0.50005));
}

TEST_CASE("the radii of a cone have no sign and are at least 1e-4") {
  CHECK(meet(Cone(-1, -2, 1, true), {5, 0, 0.5}, {-1, 0, 0})->t == about(3.5));
  CHECK(meet(Cone(0, 2, 1, true), {5, 0, 0}, {-1, 0, 0})->t == about(5 - 1e-4));
}

TEST_CASE("a cone without slope is drawn with the slope 0.001") {
  // B = 0.001, g = 1 / B: radius 1.001 at z = 1.
  const Cone tube(1, 1, 1, true);
  CHECK(meet(tube, {5, 0, 1}, {-1, 0, 0})->t == Approx(5 - 1.001).epsilon(1e-9));
  CHECK(meet(tube, {5, 0, 0}, {-1, 0, 0})->t == Approx(4).epsilon(1e-9));
}

TEST_CASE("from inside a cone the side is missed where the line behind the ray crosses it too") {
  // Roots 1.5 and -1.5, both on the side; the second is taken and lies behind.
  CHECK_FALSE(meet(funnel, {0, 0, 0.5}, {1, 0, 0}));
  CHECK_FALSE(meet(open_funnel, {0, 0, 0.5}, {1, 0, 0}));
}

TEST_CASE("from inside a cone the side is hit where the line behind the ray leaves by an end") {
  // 0.8 t = 1.9 - 0.6 t, t = 19/14; the other crossing is at z = 6.6. n is along (1, 0, -2), with the ray.
  const auto hit = meet(funnel, {0, 0, 0.9}, {0.8, 0, -0.6});
  REQUIRE(hit);
  CHECK(hit->t == about(19.0 / 14));
  CHECK(hit->normal == near(1 / std::sqrt(5), 0, -2 / std::sqrt(5)));
}

TEST_CASE("the normal of a cone without caps is turned to the ray") {
  const auto inside = meet(open_funnel, {0, 0, 0.9}, {0.8, 0, -0.6});
  REQUIRE(inside);
  CHECK(inside->normal == near(-1 / std::sqrt(5), 0, 2 / std::sqrt(5)));
  const auto outside = meet(open_funnel, {5, 0, 0.5}, {-1, 0, 0});
  REQUIRE(outside);
  CHECK(outside->normal == near(1 / std::sqrt(5), 0, -2 / std::sqrt(5)));
}

TEST_CASE("the cap of a cone at z = height faces into the cone") {
  // The cap at t = 1/0.6, x = 4/3; the side behind it at t = 3/1.4.
  const auto hit = meet(funnel, {0, 0, 2}, {0.8, 0, -0.6});
  REQUIRE(hit);
  CHECK(hit->t == about(5.0 / 3));
  CHECK(hit->normal == Vec3(0, 0, -1));
  // Without caps the side itself.
  CHECK(meet(open_funnel, {0, 0, 2}, {0.8, 0, -0.6})->t == about(15.0 / 7));
}

TEST_CASE("the cap of a cone at z = 0 faces the ray") {
  // The cap at t = 0.5/0.6, x = 13/15; the side behind it: 0.2 + 0.8 t = 0.5 + 0.6 t, t = 1.5.
  const auto hit = meet(funnel, {0.2, 0, -0.5}, {0.8, 0, 0.6});
  REQUIRE(hit);
  CHECK(hit->t == about(5.0 / 6));
  CHECK(hit->normal == Vec3(0, 0, -1));
  CHECK(meet(open_funnel, {0.2, 0, -0.5}, {0.8, 0, 0.6})->t == about(1.5));
}

TEST_CASE("a ray that meets only the caps of a cone misses it") {
  CHECK_FALSE(meet(funnel, {0.5, 0, 5}, {0, 0, -1}));
  CHECK_FALSE(meet(funnel, {0.5, 0, -5}, {0, 0, 1}));
  // The same along the axis of a cone whose side is met further out: x = 1.5 at z = 0.5, but no cap there.
  CHECK(meet(funnel, {1.5, 0, -5}, {0, 0, 1})->t == about(5.5));
}

TEST_CASE("a cone of negative height is never hit") {
  const Cone cone(1, 0, -1, GENERATE(true, false));
  const double z = GENERATE(-1.5, -0.5, 0.0, 0.5);
  CHECK_FALSE(meet(cone, {5, 0, z}, {-1, 0, 0}));
  CHECK_FALSE(meet(cone, {0.3, 0, z + 5}, {0.1, 0, -1}));
  CHECK_FALSE(meet(cone, {0.3, 0, z - 5}, {0.1, 0, 1}));
}

TEST_CASE("a cone ends at z = 0 and z = height, both included, and is missed beside and behind") {
  CHECK(meet(funnel, {5, 0, 0}, {-1, 0, 0})->t == about(4));
  CHECK(meet(funnel, {5, 0, 1}, {-1, 0, 0})->t == about(3));
  CHECK_FALSE(meet(funnel, {5, 0, -1e-15}, {-1, 0, 0}));
  CHECK_FALSE(meet(funnel, {5, 0, 1 + 1e-15}, {-1, 0, 0}));
  CHECK_FALSE(meet(funnel, {5, 0, 0.5}, {1, 0, 0}));
  CHECK_FALSE(meet(funnel, {5, 3, 0.5}, {-1, 0, 0}));
}

TEST_CASE("a ray that only touches a cone misses it") {
  // In the plane z = 0 the radius is 1: disc = 100 - 4 * 25 = 0.
  CHECK_FALSE(meet(funnel, {1, 5, 0}, {0, -1, 0}));
}

TEST_CASE("the bounds of a cone hold its wider end and its height, up or down") {
  CHECK(Cone(1, 2, 3, true).bounds().min == Vec3(-2, -2, 0));
  CHECK(Cone(1, 2, 3, true).bounds().max == Vec3(2, 2, 3));
  CHECK(Cone(-4, 2, -3, true).bounds().min == Vec3(-4, -4, -3));
  CHECK(Cone(-4, 2, -3, true).bounds().max == Vec3(4, 4, 0));
}

TEST_CASE("a cone without habits has normals at right angles to its side") {
  const Cone cone(1, 2, 1, true, Cone::Habits::none);
  const auto hit = meet(cone, {5, 0, 0.5}, {-1, 0, 0});
  REQUIRE(hit);
  CHECK(hit->t == about(3.5));
  CHECK(hit->normal == near(std::sqrt(0.5), 0, -std::sqrt(0.5)));
  CHECK(cone.facing(hit->normal) == hit->normal);
}

TEST_CASE("a cone without habits is met from inside, an open one with its normal turned to the ray") {
  const auto closed = meet(Cone(1, 2, 1, true, Cone::Habits::none), {0, 0, 0.5}, {1, 0, 0});
  REQUIRE(closed);
  CHECK(closed->t == about(1.5));
  CHECK(closed->normal == near(std::sqrt(0.5), 0, -std::sqrt(0.5)));
  const auto open = meet(Cone(1, 2, 1, false, Cone::Habits::none), {0, 0, 0.5}, {1, 0, 0});
  REQUIRE(open);
  CHECK(open->normal == near(-std::sqrt(0.5), 0, std::sqrt(0.5)));
  CHECK_FALSE(meet(open_funnel, {0, 0, 0.5}, {1, 0, 0}));  // a habit
}

TEST_CASE("the caps of a cone without habits face outward and are met by rays that meet nothing else") {
  const Cone cone(1, 2, 1, true, Cone::Habits::none);
  const auto top = meet(cone, {0, 0, 5}, {0, 0, -1});
  REQUIRE(top);
  CHECK(top->t == about(4));
  CHECK(top->normal == Vec3(0, 0, 1));
  const auto bottom = meet(cone, {0, 0, 0.5}, {0, 0, -1});
  REQUIRE(bottom);
  CHECK(bottom->t == about(0.5));
  CHECK(bottom->normal == Vec3(0, 0, -1));
  CHECK_FALSE(meet(Cone(1, 2, 1, false, Cone::Habits::none), {0, 0, 5}, {0, 0, -1}));
}
