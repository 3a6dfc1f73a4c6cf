#include "geometry/triangle.hpp"

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_rays.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// Corners (0,0,0), (1,0,0), (0,1,0): u and v of a point are its x and y, and all sums below are exact.
const Corners corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

Meeting meeting(const Corners& where, const Ray& ray, TriangleHit& hit) {
  const Meeting fast = meets(Triangle(where), ray, hit);
  return fast == Meeting::unsure ? meets_after_all(where, ray, hit) : fast;
}

bool meets(const Corners& where, const Ray& ray, TriangleHit& hit) {
  return meeting(where, ray, hit) == Meeting::hit;
}

bool hits_at(double x, double y) {
  TriangleHit hit;
  return meets(corners, {{x, y, 2}, {0, 0, -1}}, hit);
}

}  // namespace

TEST_CASE("a triangle is hit from both sides, with the weights of its second and third corner") {
  const double z = GENERATE(2.0, -2.0);
  TriangleHit hit;
  REQUIRE(meets(corners, {{0.25, 0.5, z}, {0, 0, -z / 2}}, hit));
  CHECK(hit.t == 2);
  CHECK(hit.u == 0.25);
  CHECK(hit.v == 0.5);
}

TEST_CASE("edges and corners belong to a triangle, what is beyond them does not") {
  const double just = GENERATE(0x1p-52, 1e-9, 0.5);
  for (const double along : {0.0, 0.25, 0.5, 1.0}) {
    INFO("along " << along);
    CHECK(hits_at(along, 0));
    CHECK(hits_at(0, along));
    CHECK(hits_at(along, 1 - along));
    CHECK_FALSE(hits_at(along, -just));
    CHECK_FALSE(hits_at(-just, along));
    CHECK_FALSE(hits_at(along + just, 1 - along));
  }
}

TEST_CASE("a triangle behind the ray, or in whose plane the ray runs, is missed") {
  TriangleHit hit;
  CHECK_FALSE(meets(corners, {{0.25, 0.25, 2}, {0, 0, 1}}, hit));
  CHECK_FALSE(meets(corners, {{-1, 0.25, 0}, {1, 0, 0}}, hit));
  CHECK_FALSE(meets(corners, {{-1, 0.25, 0.5}, {1, 0, 0}}, hit));
}

TEST_CASE("a triangle is hit however near it is, unless the origin may lie in its plane") {
  // t = ac . (o x ab) = o.z.
  const double z = GENERATE(1e-8, 1e-16, 1e-200);
  TriangleHit hit;
  REQUIRE(meets(corners, {{0.25, 0.25, z}, {0, 0, -1}}, hit));
  CHECK(hit.t == z);
  CHECK_FALSE(meets(corners, {{0.25, 0.25, z}, {0, 0, -1}, z}, hit));
  CHECK_FALSE(meets(corners, {{0.25, 0.25, 0}, {0, 0, -1}}, hit));
  CHECK_FALSE(meets(corners, {{0.25, 0.25, -z}, {0, 0, -1}}, hit));
}

TEST_CASE(
    "of two triangles at an edge the ray crosses exactly the one on its side, wherever rounding would put "
    "it") {
  // The edge from (0, 0, 1) to (3, 1, 1) seen from the origin: a direction p passes it on the left where
  // p.y 3 - p.x > 0. With whole numbers that is exact.
  const Vec3 a(0, 0, 1), b(3, 1, 1), left(0, 5, 1), right(5, 0, 1);
  const double x = 1.5 + GENERATE(-0x1p-52, 0.0, 0x1p-52), y = 0.5;
  const Ray ray{Vec3(0), Vec3(x, y, 1) / 2.0};
  TriangleHit hit;
  const bool on_left = crosses_exactly({a, b, left}, ray, hit),
             on_right = crosses_exactly({b, a, right}, ray, hit);
  CHECK(on_left == (3 * y >= x));
  CHECK(on_right == (3 * y <= x));
  CHECK(crosses_exactly({left, a, b}, ray, hit) == on_left);
  CHECK(crosses_exactly({b, left, a}, ray, hit) == on_left);
  CHECK(crosses_exactly({a, left, b}, ray, hit) == on_left);
}

TEST_CASE("triangles of any size are hit, as a gap where the course's products leave the range of doubles") {
  const double size = GENERATE(1e-300, 1e-150, 1e-9, 1e9, 1e150, 1e300);
  TriangleHit hit;
  const Corners where{{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
  const bool in_range = size > 1e-200 && size < 1e200;
  REQUIRE(meeting(where, {{0.25 * size, 0.5 * size, 2 * size}, {0, 0, -1}}, hit) ==
          (in_range ? Meeting::hit : Meeting::gap));
  CHECK(hit.t / size == about(2));
  CHECK(hit.u == about(0.25));
  CHECK(hit.v == about(0.5));
  CHECK(meeting(where, {{0.6 * size, 0.5 * size, 2 * size}, {0, 0, -1}}, hit) == Meeting::none);
}

TEST_CASE("a triangle without area is never hit") {
  const Corners line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  TriangleHit hit;
  CHECK_FALSE(meets(line, ray({0.5, 0, 2}, {0, 0, -1}), hit));
  CHECK_FALSE(meets(line, ray({0.5, 0.5, 2}, {0.1, -0.3, -1}), hit));
  CHECK_FALSE(is_finite(face_normal(Triangle(line))));
}

TEST_CASE("the corners of a face run counter-clockwise around its normal") {
  CHECK(face_normal(Triangle(corners)) == Vec3(0, 0, 1));
  CHECK(face_normal(Triangle({{0, 0, 0}, {0, 3, 0}, {2, 0, 0}})) == Vec3(0, 0, -1));
  // (b-a) x (c-a) = (0,1,-1) x (1,0,-1) = (-1,-1,-1).
  CHECK(face_normal(Triangle({{5, 5, 5}, {5, 6, 4}, {6, 5, 4}})) == near(Vec3(-1 / std::sqrt(3))));
}
