#include "geometry/frame.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

Mat4 scaled(const Vec3& s) {
  return glm::scale(Mat4(1), s);
}

}  // namespace

TEST_CASE(
    "a ray in the space of an object has unit direction and says how long a step of the world is there") {
  const Frame frame(glm::translate(Mat4(1), Vec3(1, 2, 3)) * scaled({4, 4, 0.5}));
  const ObjectRay along_z(frame, {{1, 2, 5}, {0, 0, -1}});
  CHECK(along_z.ray.origin == near(0, 0, 4));
  CHECK(along_z.ray.direction == near(0, 0, -1));
  CHECK(along_z.scale == about(2));  // so t' = 4 there is t = 2 here
  const ObjectRay along_x(frame, {{1, 2, 5}, {1, 0, 0}});
  CHECK(along_x.scale == about(0.25));
  // (0.6, 0, 0.8) becomes (0.15, 0, 1.6), of length sqrt(2.5825).
  const ObjectRay slanting(frame, {{1, 2, 3}, {0.6, 0, 0.8}});
  CHECK(slanting.scale == about(std::sqrt(2.5825)));
  CHECK(slanting.ray.direction == near(Vec3(0.15, 0, 1.6) / std::sqrt(2.5825)));
}

TEST_CASE("normals go by the inverse transpose under a scale that differs by axis") {
  const Frame frame(scaled({2, 1, 1}));
  CHECK(frame.world_normal({1, 1, 0}) == near(Vec3(1, 2, 0) / std::sqrt(5.0)));
  CHECK(frame.world_normal({1, 0, 0}) == near(1, 0, 0));
}

TEST_CASE("a mirror image keeps normals outward") {
  CHECK(Frame(scaled({-1, 1, 1})).world_normal({1, 0, 0}) == near(-1, 0, 0));
  CHECK(Frame(scaled({-1, -1, -1})).world_normal({0, 0.6, 0.8}) == near(0, -0.6, -0.8));
}

TEST_CASE("moving an object leaves its normals") {
  CHECK(Frame(glm::translate(Mat4(1), Vec3(100, 200, 300))).world_normal({0.6, 0, 0.8}) == near(0.6, 0, 0.8));
}

TEST_CASE("normals turn with the object") {
  const Frame frame(glm::rotate(Mat4(1), std::acos(-1.0) / 2, Vec3(0, 0, 1)));
  CHECK(frame.world_normal({1, 0, 0}) == near(0, 1, 0));
}

TEST_CASE("a place without an inverse says so") {
  CHECK(Frame(Mat4(1)).invertible());
  CHECK(Frame(scaled({1e-3, -1e3, 1e6})).invertible());
  CHECK_FALSE(Frame(scaled({0, 1, 1})).invertible());
  CHECK_FALSE(Frame(scaled({0, 0, 0})).invertible());
  CHECK_FALSE(Frame(glm::rotate(Mat4(1), 1.0, Vec3(0))).invertible());
  Mat4 flat(1);
  flat[2] = flat[1];  // columns 1 and 2 alike
  CHECK_FALSE(Frame(flat).invertible());
}
