#include "geometry/box.hpp"

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_rays.hpp"

using namespace trace;
using namespace trace::test;

namespace {

struct Face {
  int axis;
  double side;  // -1 or 1
  Vec2 uv;      // of the point (0.1, 0.2, 0.3) moved onto the face
};

// With lo < hi the other two axes: u = 1/2 - p[lo] on min faces, 1/2 + p[lo] on max faces; v = 1/2 + p[hi].
Face any_face() {
  return GENERATE(Face{0, -1, {0.3, 0.8}}, Face{1, -1, {0.4, 0.8}}, Face{2, -1, {0.4, 0.7}},
                  Face{0, 1, {0.7, 0.8}}, Face{1, 1, {0.6, 0.8}}, Face{2, 1, {0.6, 0.7}});
}

Vec3 along(int axis, double value) {
  Vec3 v(0);
  v[axis] = value;
  return v;
}

}  // namespace

TEST_CASE("each face of a box is hit from outside with its normal outward and its own texture coordinates") {
  const Face face = any_face();
  Vec3 origin(0.1, 0.2, 0.3);
  origin[face.axis] = 3 * face.side;
  const auto hit = meet(Box{}, origin, along(face.axis, -face.side));
  REQUIRE(hit);
  CHECK(hit->t == 2.5);
  CHECK(hit->normal == along(face.axis, face.side));
  CHECK(hit->uv.x == about(face.uv.x));
  CHECK(hit->uv.y == about(face.uv.y));
}

TEST_CASE("each face of a box is hit from inside with its normal still outward") {
  const Face face = any_face();
  const auto hit = meet(Box{}, {0.1, 0.2, 0.3}, along(face.axis, face.side));
  REQUIRE(hit);
  CHECK(hit->t == about(0.5 - face.side * Vec3(0.1, 0.2, 0.3)[face.axis]));
  CHECK(hit->normal == along(face.axis, face.side));
}

TEST_CASE("edges and corners belong to a box, what is beyond them does not") {
  const double x = GENERATE(-0.5, 0.5), y = GENERATE(-0.5, 0.0, 0.5);
  CHECK(meet(Box{}, {x, y, 5}, {0, 0, -1})->t == 4.5);
  CHECK_FALSE(meet(Box{}, {x * (1 + 1e-15), y, 5}, {0, 0, -1}));
}

TEST_CASE("of faces at the same distance a box reports the first of -x -y -z +x +y +z") {
  // The directions are not of unit length, so that all of it is exact.
  LocalHit hit;
  REQUIRE(Box{}.intersect({{1, 1, 0}, {-1, -1, 0}}, hit));
  CHECK(hit.t == 0.5);
  CHECK(hit.normal == Vec3(1, 0, 0));
  REQUIRE(Box{}.intersect({{1, -1, 0}, {-1, 1, 0}}, hit));
  CHECK(hit.normal == Vec3(0, -1, 0));
  REQUIRE(Box{}.intersect({{1, 1, -1}, {-1, -1, 1}}, hit));
  CHECK(hit.normal == Vec3(0, 0, -1));
}

TEST_CASE("a box behind the ray or beside it is missed") {
  CHECK_FALSE(meet(Box{}, {0, 0, 5}, {0, 0, 1}));
  CHECK_FALSE(meet(Box{}, {2, 0, 5}, {0, 0, -1}));
  CHECK_FALSE(meet(Box{}, {3, 0, 0}, {-1, 1, 0}));
}

TEST_CASE("a ray that leaves a face of a box does not hit that face again") {
  CHECK_FALSE(meet(Box{}, {0, 0, 0.5}, {0, 0, 1}));
  CHECK(meet(Box{}, {0, 0, 0.5}, {0, 0, -1})->t == 1);
}

TEST_CASE("the near face of a box counts however near it is, unless the origin may lie on it") {
  LocalHit hit;
  Ray ray{{0, 0, 0.5 + 0x1p-50}, {0, 0, -1}};
  REQUIRE(Box{}.intersect(ray, hit));
  CHECK(hit.t == 0x1p-50);
  ray.origin_error = 0x1p-50;
  REQUIRE(Box{}.intersect(ray, hit));
  CHECK(hit.normal == Vec3(0, 0, -1));  // only the far face is left
}

TEST_CASE("a ray within a face of a box meets the sides of the box") {
  const auto hit = meet(Box{}, {-3, 0.5, 0.25}, {1, 0, 0});
  REQUIRE(hit);
  CHECK(hit->t == 2.5);
  CHECK(hit->normal == Vec3(-1, 0, 0));
}
