#include "geometry/triangle.hpp"

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_rays.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// Corners (0,0,0), (1,0,0), (0,1,0): u and v of a point are its x and y, and all sums below are exact.
const Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

bool hits_at(double x, double y) {
  TriangleHit hit;
  return intersect(triangle, {{x, y, 2}, {0, 0, -1}}, hit);
}

}  // namespace

TEST_CASE("a triangle is hit from both sides, with the weights of its second and third corner") {
  const double z = GENERATE(2.0, -2.0);
  TriangleHit hit;
  REQUIRE(intersect(triangle, {{0.25, 0.5, z}, {0, 0, -z / 2}}, hit));
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
  CHECK_FALSE(intersect(triangle, {{0.25, 0.25, 2}, {0, 0, 1}}, hit));
  CHECK_FALSE(intersect(triangle, {{-1, 0.25, 0}, {1, 0, 0}}, hit));
  CHECK_FALSE(intersect(triangle, {{-1, 0.25, 0.5}, {1, 0, 0}}, hit));
}

TEST_CASE("a triangle exactly 1e-8 away is hit, a nearer one is not") {
  // t = ac . (o x ab) = o.z.
  TriangleHit hit;
  CHECK(intersect(triangle, {{0.25, 0.25, 1e-8}, {0, 0, -1}}, hit));
  CHECK(hit.t == 1e-8);
  CHECK_FALSE(intersect(triangle, {{0.25, 0.25, 0.999999e-8}, {0, 0, -1}}, hit));
  CHECK_FALSE(intersect(triangle, {{0.25, 0.25, 0}, {0, 0, -1}}, hit));
}

TEST_CASE("a triangle without area is never hit") {
  const Triangle line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  TriangleHit hit;
  CHECK_FALSE(intersect(line, ray({0.5, 0, 2}, {0, 0, -1}), hit));
  CHECK_FALSE(intersect(line, ray({0.5, 0.5, 2}, {0.1, -0.3, -1}), hit));
  CHECK_FALSE(is_finite(face_normal(line)));
}

TEST_CASE("the corners of a face run counter-clockwise around its normal") {
  CHECK(face_normal(triangle) == Vec3(0, 0, 1));
  CHECK(face_normal({{0, 0, 0}, {0, 3, 0}, {2, 0, 0}}) == Vec3(0, 0, -1));
  // (b-a) x (c-a) = (0,1,-1) x (1,0,-1) = (-1,-1,-1).
  CHECK(face_normal({{5, 5, 5}, {0, 1, -1}, {1, 0, -1}}) == near(Vec3(-1 / std::sqrt(3))));
}
