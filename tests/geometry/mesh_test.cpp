#include "geometry/mesh.hpp"

#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// Two faces at a right angle on the edge from point 0 to point 1: one in the plane z = 0 (normal +z), one,
// four times as large, in the plane y = 0 (normal -y).
Mesh angle() {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 4}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}};
  return mesh;
}

}  // namespace

TEST_CASE("a polygon becomes a fan around its first corner") {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}};
  const std::uint32_t corners[] = {0, 1, 2, 3, 4};
  add_polygon(mesh, corners, 5);
  CHECK(mesh.faces == std::vector<FaceCorners>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
}

TEST_CASE("a face with two corners at the same place is dropped, the rest of its fan is not") {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}};  // 1 and 2 are the same place
  const std::uint32_t twice_the_same[] = {0, 1, 1};
  add_polygon(mesh, twice_the_same, 3);
  const std::uint32_t quadrilateral[] = {0, 1, 2, 3};
  add_polygon(mesh, quadrilateral, 4);
  CHECK(mesh.faces == std::vector<FaceCorners>{{0, 2, 3}});
}

TEST_CASE("a face whose corners lie on a line is kept") {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const std::uint32_t line[] = {0, 1, 2};
  add_polygon(mesh, line, 3);
  CHECK(mesh.faces.size() == 1);
}

TEST_CASE("a generated normal is the mean of the unit normals around the point, whatever their areas") {
  Mesh mesh = angle();
  generate_normals(mesh);
  REQUIRE(mesh.normals.size() == 4);
  CHECK(mesh.normals[0] == near(0, -0.5, 0.5));  // not made a unit vector
  CHECK(mesh.normals[1] == near(0, -0.5, 0.5));
  CHECK(mesh.normals[2] == near(0, 0, 1));
  CHECK(mesh.normals[3] == near(0, -1, 0));
}

TEST_CASE("a given normal is one more term of a generated one, but not of the number it is divided by") {
  Mesh mesh = angle();
  mesh.normals = {{0, 0, 4}, {0, 0, 0}, {6, 0, 0}, {0, 0, 0}};
  generate_normals(mesh);
  CHECK(mesh.normals[0] == near(0, -0.5, 2.5));  // ((0,0,4) + (0,0,1) + (0,-1,0)) / 2
  CHECK(mesh.normals[2] == near(6, 0, 1));       // ((6,0,0) + (0,0,1)) / 1
}

TEST_CASE("generating normals leaves a point without faces as it was given") {
  Mesh mesh = angle();
  mesh.points.push_back({9, 9, 9});
  mesh.normals = {5, Vec3(0, 3, 0)};
  generate_normals(mesh);
  CHECK(mesh.normals[4] == Vec3(0, 3, 0));
}

TEST_CASE("a face without area makes the generated normals of its corners undefined, and no others") {
  Mesh mesh = angle();
  mesh.points.push_back({2, 0, 0});
  mesh.faces.push_back({0, 1, 4});
  generate_normals(mesh);
  CHECK_FALSE(is_finite(mesh.normals[0]));
  CHECK_FALSE(is_finite(mesh.normals[4]));
  CHECK(mesh.normals[2] == near(0, 0, 1));
}

TEST_CASE("a smooth normal weighs the corners' normals as they are and then has unit length") {
  Mesh mesh = angle();
  mesh.normals = {{4, 0, 0}, {0, 2, 0}, {0, 0, 1}, {0, 0, 1}};
  CHECK(mesh.smooth_normal(0, {0, 0}) == near(1, 0, 0));
  CHECK(mesh.smooth_normal(0, {1, 0}) == near(0, 1, 0));
  CHECK(mesh.smooth_normal(0, {0, 1}) == near(0, 0, 1));
  // 1/4 (4,0,0) + 1/2 (0,2,0) + 1/4 (0,0,1) = (1, 1, 1/4), of length sqrt(33)/4.
  CHECK(mesh.smooth_normal(0, {0.5, 0.25}) == near(Vec3(4, 4, 1) / std::sqrt(33.0)));
}

TEST_CASE("vertex normals that cancel give no normal") {
  Mesh mesh = angle();
  mesh.normals = {{0, 0, 1}, {0, 0, -1}, {0, 0, 0}, {0, 0, 0}};
  CHECK_FALSE(is_finite(mesh.smooth_normal(0, {0.5, 0})));
  CHECK(is_finite(mesh.smooth_normal(0, {0.25, 0})));
}

TEST_CASE("the bounds of a mesh hold all its points, used by a face or not") {
  Mesh mesh = angle();
  mesh.points.push_back({-7, 3, 0});
  CHECK(mesh.bounds().min == Vec3(-7, 0, 0));
  CHECK(mesh.bounds().max == Vec3(1, 3, 4));
  CHECK(Mesh{}.bounds().empty());
}
