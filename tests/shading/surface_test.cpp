// The rays that leave a surface.
#include "shading/surface.hpp"

#include "tests/support/constants.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/quad.hpp"
#include "tests/support/scene_random.hpp"

using namespace trace;
using namespace trace::test;

namespace {

Vec3 any_direction(Random& random) {
  for (;;) {
    const Vec3 v = random.in_cube(1);
    if (glm::dot(v, v) > 0.01) return glm::normalize(v);
  }
}

Scene one_object(const Shape& shape, const Mat4& place) {
  Scene scene;
  add(scene, shape, place, Material{});
  return scene;
}

}  // namespace

TEST_CASE("a ray that leaves a surface starts at the very point that was hit") {
  Random random(1);
  const Scene scene = random_scene(random, 20);
  const SceneTree tree(scene);
  int hits = 0;
  for (int i = 0; i < 500; ++i) {
    const Ray ray = random_ray(random);
    const Hit hit = tree.closest(ray, false);
    if (!hit) continue;
    ++hits;
    const Vec3 direction = any_direction(random);
    const Ray leaving = Surface(scene, ray, hit, true).leaving(direction);
    CHECK(leaving.origin == ray.at(hit.t));
    CHECK(leaving.direction == direction);
    CHECK(leaving.origin_error > 0);
    CHECK(leaving.least_t >= 0);
  }
  CHECK(hits > 100);
}

TEST_CASE(
    "the origin of a leaving ray is within its error of the surface, which grows with the coordinates") {
  Random random(2);
  double last = 0;
  for (const double offset : {0.0, 64.0, 4096.0, 262144.0, 16777216.0}) {
    INFO("offset " << offset);
    const Vec3 centre(offset, -offset, offset);  // placed without rounding
    const Scene scene = one_object(Sphere{}, glm::translate(Mat4(1), centre));
    const SceneTree tree(scene);
    double largest_error = 0;
    int hits = 0, beyond = 0;
    for (int i = 0; i < 1'000; ++i) {
      const Vec3 origin = centre + 5.0 * any_direction(random);
      const Vec3 target = centre + random.in_cube(0.5);
      const Ray ray{origin, glm::normalize(target - origin)};
      const Hit hit = tree.closest(ray, false);
      if (!hit) continue;
      ++hits;
      const Ray leaving = Surface(scene, ray, hit, true).leaving(any_direction(random));
      Quad squared = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const Quad d = Quad(leaving.origin[axis]) - centre[axis];
        squared += d * d;
      }
      // A displacement of e in each coordinate is one of sqrt(3) e.
      if (magnitude(root(squared) - 1) > root(Quad(3)) * leaving.origin_error) ++beyond;
      largest_error = std::max(largest_error, leaving.origin_error);
    }
    CHECK(hits == 1'000);
    CHECK(beyond == 0);
    CHECK(largest_error > 2 * last);
    CHECK(largest_error < 1e-14 * (1 + offset));
    last = largest_error;
  }
}

TEST_CASE("a ray that leaves a convex object outward does not meet it, wherever and however large it is") {
  Random random(3);
  int hits = 0, again = 0, shadowed = 0;
  for (int i = 0; i < 400; ++i) {
    const double size = std::pow(10, random.between(-8, 8)), distance = std::pow(10, random.between(-2, 6));
    const Vec3 away = size * distance * any_direction(random), axis = any_direction(random);
    const double angle = random.between(0, 6);
    const Shape shapes[] = {Sphere{}, Box{}, Square{}, Cylinder{}};
    const Mat4 place = glm::translate(Mat4(1), away) * glm::rotate(Mat4(1), angle, axis) * scaled(size);
    const Scene scene = one_object(shapes[i % 4], place);
    const SceneTree tree(scene);
    for (int j = 0; j < 20; ++j) {
      const Vec3 direction = any_direction(random);
      const Ray ray{Vec3(place * Vec4(random.in_cube(0.4), 1)) - 4 * size * direction, direction};
      const Hit hit = tree.closest(ray, false);
      if (!hit) continue;
      ++hits;
      const Surface surface(scene, ray, hit, true);
      Vec3 onward = any_direction(random);
      if (glm::dot(onward, surface.normal()) < 0) onward = -onward;
      const Ray leaving = surface.leaving(onward);
      if (tree.closest(leaving, false)) ++again;
      if (tree.occluded(leaving, infinity)) ++shadowed;
    }
  }
  CHECK(hits > 4'000);
  CHECK(again == 0);
  CHECK(shadowed == 0);
}

TEST_CASE("a ray along a surface has no least distance, one that rises has one, longer the flatter it is") {
  const Scene scene = one_object(Square{}, at_origin());
  const SceneTree tree(scene);
  const Ray down{{0.1, 0.2, 3}, {0, 0, -1}};
  const Surface surface(scene, down, tree.closest(down, false), true);
  CHECK(surface.leaving({1, 0, 0}).least_t == 0);
  const double upright = surface.leaving({0, 0, 1}).least_t, flat = surface.leaving({0.8, 0, 0.6}).least_t;
  CHECK(upright > 0);
  CHECK(upright < 1e-14);
  CHECK(flat == about(upright / 0.6));
  CHECK(flat > upright);
  CHECK(surface.leaving({0, 0, -1}).least_t == upright);
}
