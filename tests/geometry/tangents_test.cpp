// Directions in which texture coordinates grow.
#include <numbers>

#include "geometry/mesh.hpp"
#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

Mesh mapped_triangle(const Vec2& a, const Vec2& b, const Vec2& c) {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  mesh.coordinates = {a, b, c};
  mesh.faces = {{0, 1, 2}};
  return mesh;
}

}  // namespace

TEST_CASE("a mesh's texture coordinates are interpolated between the corners of a face") {
  const Mesh mesh = mapped_triangle({0.25, 0.5}, {0.75, 0.5}, {0.25, 1.5});
  CHECK(mesh.coordinates_at(0, {0, 0}) == Vec2(0.25, 0.5));
  CHECK(mesh.coordinates_at(0, {1, 0}) == Vec2(0.75, 0.5));
  CHECK(mesh.coordinates_at(0, {0, 1}) == Vec2(0.25, 1.5));
  CHECK(mesh.coordinates_at(0, {0.5, 0.25}) == Vec2(0.5, 0.75));
}

TEST_CASE("a face's tangents go with its texture coordinates, mirrored or not") {
  const auto along = [](const Mesh& mesh) {
    const auto tangents = mesh.tangents(0);
    REQUIRE(tangents);
    return Tangents{glm::normalize(tangents->along_u), glm::normalize(tangents->along_v)};
  };
  const Tangents plain = along(mapped_triangle({0, 0}, {1, 0}, {0, 1}));
  CHECK(plain.along_u == near(1, 0, 0));
  CHECK(plain.along_v == near(0, 1, 0));
  const Tangents mirrored = along(mapped_triangle({1, 0}, {0, 0}, {1, 1}));
  CHECK(mirrored.along_u == near(-1, 0, 0));
  CHECK(mirrored.along_v == near(0, 1, 0));
  const Tangents turned = along(mapped_triangle({0, 0}, {0, 1}, {1, 0}));
  CHECK(turned.along_u == near(0, 1, 0));
  CHECK(turned.along_v == near(1, 0, 0));
}

TEST_CASE("a face whose corners have texture coordinates on a line has no tangents") {
  CHECK_FALSE(mapped_triangle({0, 0}, {0, 0}, {0, 0}).tangents(0));
  CHECK_FALSE(mapped_triangle({0, 0}, {1, 1}, {0.5, 0.5}).tangents(0));
  Mesh line = mapped_triangle({0, 0}, {1, 0}, {0, 1});
  line.points[2] = {1, 0, 0};
  CHECK_FALSE(line.tangents(0));
}

TEST_CASE("tangents by differences are those of a cylinder's coordinates, across their seam too") {
  const auto around = [](const Vec3& p) {
    return Vec2(0.5 + std::atan2(p.y, p.x) / (2 * std::numbers::pi), p.z);
  };
  for (const double angle : {0.1, 1.0, 2.0, std::numbers::pi, -3.0, -0.5}) {
    const Vec3 n(std::cos(angle), std::sin(angle), 0);
    const auto found = tangents_by_differences(around, n + Vec3(0, 0, 0.5), n);
    REQUIRE(found);
    CHECK(glm::normalize(found->along_u) == near(Vec3(-n.y, n.x, 0), 1e-8));
    CHECK(glm::normalize(found->along_v) == near(Vec3(0, 0, 1), 1e-8));
  }
  // On the axis the way around has no direction.
  CHECK_FALSE(tangents_by_differences([](const Vec3&) { return Vec2(0.5); }, Vec3(0), Vec3(0, 0, 1)));
}
