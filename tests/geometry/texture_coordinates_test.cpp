// Where a place of a surface is in a texture.
#include "geometry/texture_coordinates.hpp"

#include "geometry/cone.hpp"
#include "geometry/cylinder.hpp"
#include "geometry/plane.hpp"
#include "geometry/quadric.hpp"
#include "geometry/sphere.hpp"
#include "geometry/torus.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_random.hpp"

using namespace trace;
using namespace trace::test;

namespace {

Vec3 flat(const Vec2& uv) {
  return {uv.x, uv.y, 0};
}

}  // namespace

TEST_CASE("a map goes round a sphere from +z by +x, -z and -x, and up from -y to +y") {
  const Sphere sphere;
  const auto at = [&](const Vec3& p) { return flat(sphere.texture_coordinates(p, p)); };
  CHECK(at({0, 0, -1}) == near(0.5, 0.5, 0));
  CHECK(at({1, 0, 0}) == near(0.25, 0.5, 0));
  CHECK(at({-1, 0, 0}) == near(0.75, 0.5, 0));
  CHECK(at({0, 1, 0}).y == 1);
  CHECK(at({0, -1, 0}).y == 0);
  CHECK(at({0, std::sqrt(0.5), -std::sqrt(0.5)}) == near(0.5, 0.75, 0));
  CHECK(at(Vec3(1e-3, 0, 1)).x < 0.01);
  CHECK(at(Vec3(-1e-3, 0, 1)).x > 0.99);
}

TEST_CASE("a map goes round a cylinder and a cone, and up their height; caps show it flat") {
  const Cylinder cylinder;
  CHECK(flat(cylinder.texture_coordinates({1, 0, 0.25}, {1, 0, 0})) == near(0.5, 0.25, 0));
  CHECK(flat(cylinder.texture_coordinates({0, 1, 1}, {0, 1, 0})) == near(0.75, 1, 0));
  CHECK(flat(cylinder.texture_coordinates({0, -1, 1}, {0, -1, 0})) == near(0.25, 1, 0));
  CHECK(flat(cylinder.texture_coordinates({0.5, -0.5, 1}, {0, 0, 1})) == near(0.75, 0.25, 0));
  CHECK(flat(Tube{}.texture_coordinates({1, 0, 0.25}, {-1, 0, 0})) == near(0.5, 0.25, 0));
  const Cone cone(2, 1, 4, true);
  CHECK(flat(cone.texture_coordinates({1.5, 0, 2}, {1, 0, 0.25})) == near(0.5, 0.5, 0));
  CHECK(flat(cone.texture_coordinates({2, 0, 0}, {0, 0, -1})) == near(1, 0.5, 0));
  CHECK(flat(cone.texture_coordinates({0, 1, 4}, {0, 0, 1})) == near(0.5, 1, 0));
}

TEST_CASE("a map repeats each unit of a plane, from its point on") {
  const Plane floor(Vec3(10, 0, 0), Vec3(0, 0, 1));
  CHECK(flat(floor.texture_coordinates({10.25, 0.5, 0}, {0, 0, 1})) == near(0.25, 0.5, 0));
  CHECK(flat(floor.texture_coordinates({13.25, -0.5, 0}, {0, 0, 1})) == near(0.25, 0.5, 0));
  const Plane wall(Vec3(0), Vec3(1, 0, 0));
  CHECK(flat(wall.texture_coordinates({0, 0.25, -0.125}, {1, 0, 0})) == near(0.125, 0.25, 0));
  const Plane ground(Vec3(0), Vec3(0, 1, 0));
  CHECK(flat(ground.texture_coordinates({0.25, 0, -0.125}, {0, 1, 0})) == near(0.25, 0.125, 0));
}

TEST_CASE("a map goes round the axis of a torus and round its tube") {
  const Torus torus(2, 0.5);
  CHECK(flat(torus.texture_coordinates({2.5, 0, 0}, {1, 0, 0})) == near(0.5, 0.5, 0));
  CHECK(flat(torus.texture_coordinates({0, 2, 0.5}, {0, 0, 1})) == near(0.75, 0.75, 0));
  CHECK(flat(torus.texture_coordinates({0, -2, -0.5}, {0, 0, -1})) == near(0.25, 0.25, 0));
}

TEST_CASE("texture coordinates are within the unit square, also beside the surface and far from it") {
  Random random(9);
  const Quadric whole({1, 1, -1, 0, 0, 0, 0, 0, 0, -1});
  const Quadric part({1, 0, 1, 0, 0, 0, 0, -1, 0, 0}, Bounds::everything(), {Vec3(-1, 0, -1), Vec3(1)});
  for (int i = 0; i < 2000; ++i) {
    const double size = std::pow(10.0, random.between(-9, 9));
    const Vec3 p = size * random.on_grid(4, 0.25);
    const Vec3 n = random.on_grid(1, 1);
    for (const Vec2& uv :
         {Sphere{}.texture_coordinates(p, n), Cylinder{}.texture_coordinates(p, n),
          Cone(1, 0, 1, true).texture_coordinates(p, n),
          Plane(Vec3(0), Vec3(1, 2, 3)).texture_coordinates(p, n), Torus(1, 0.5).texture_coordinates(p, n),
          whole.texture_coordinates(p, n), part.texture_coordinates(p, n)}) {
      REQUIRE((uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1));
    }
  }
}
