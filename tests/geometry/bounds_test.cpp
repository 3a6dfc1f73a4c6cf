#include "geometry/bounds.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_rays.hpp"

using namespace trace;
using namespace trace::test;

namespace {

const Bounds cube{Vec3(-1), Vec3(1)};

}  // namespace

TEST_CASE("bounds are empty until something is added, and then just hold it") {
  Bounds bounds;
  CHECK(bounds.empty());
  bounds.add(Vec3(1, 2, 3));
  CHECK_FALSE(bounds.empty());
  bounds.add(Vec3(0, 5, 3));
  CHECK(bounds.min == Vec3(0, 2, 3));
  CHECK(bounds.max == Vec3(1, 5, 3));
  bounds.add(Bounds{Vec3(-1), Vec3(1)});
  CHECK(bounds.min == Vec3(-1, -1, -1));
  CHECK(bounds.max == Vec3(1, 5, 3));
}

TEST_CASE("bounds that hold a number that is none are empty") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(Bounds{Vec3(0, nan, 0), Vec3(1)}.empty());
  CHECK(Bounds{Vec3(0), Vec3(1, 1, nan)}.empty());
}

TEST_CASE("the bounds of transformed bounds hold the eight transformed corners") {
  const Mat4 turned = glm::rotate(Mat4(1), std::acos(-1.0) / 4, Vec3(0, 0, 1));
  const Bounds bounds = transformed(cube, glm::translate(Mat4(1), Vec3(10, 0, 0)) * turned);
  CHECK(bounds.min == near(10 - std::sqrt(2), -std::sqrt(2), -1));
  CHECK(bounds.max == near(10 + std::sqrt(2), std::sqrt(2), 1));
  const Bounds mirrored = transformed({Vec3(1), Vec3(2)}, glm::scale(Mat4(1), Vec3(-1, 2, -3)));
  CHECK(mirrored.min == Vec3(-2, 2, -6));
  CHECK(mirrored.max == Vec3(-1, 4, -3));
}

TEST_CASE("bounds are hit from outside and inside, and missed behind and beside") {
  CHECK(hits_bounds(cube, ray({0.5, 0.5, 5}, {0, 0, -1})));
  CHECK(hits_bounds(cube, ray({0.5, 0.5, 0.5}, {1, 2, 3})));
  CHECK(hits_bounds(cube, ray({5, 5, 5}, {-1, -1, -1})));
  CHECK_FALSE(hits_bounds(cube, ray({0.5, 0.5, 5}, {0, 0, 1})));
  CHECK_FALSE(hits_bounds(cube, ray({5, 0, 5}, {-1, 0.5, 0.5})));
}

TEST_CASE("the test of bounds has no tolerance, and their edges belong to them") {
  // Directions not of unit length, so that nothing rounds: through the edge (1, 1, z), and beside it.
  CHECK(hits_bounds(cube, {{3, -1, 0}, {-1, 1, 0}}));
  CHECK_FALSE(hits_bounds(cube, {{3 + 0x1p-50, -1, 0}, {-1, 1, 0}}));
}

TEST_CASE("an axis along which the ray does not move is passed over") {
  CHECK(hits_bounds(cube, {{5, 7, 3}, {0, -0.0, -1}}));
  CHECK_FALSE(hits_bounds(cube, {{5, 7, 3}, {0, 0, 1}}));
}

TEST_CASE("bounds that end however little ahead of the origin are hit") {
  CHECK(hits_bounds({Vec3(-1), Vec3(1, 1, 1e-300)}, {{0, 0, 0}, {0, 0, 1}}));
  CHECK_FALSE(hits_bounds({Vec3(-1), Vec3(1, 1, -1e-300)}, {{0, 0, 0}, {0, 0, 1}}));
}
