// Random scenes with the shapes of the dialects, planes and quadrics without an end among them.
#pragma once

#include "tests/support/scene_random.hpp"

namespace trace::test {

// A place of one of random_scene()'s kinds: on a grid and upright, or anywhere.
inline Mat4 endless_place(Random& random, double unit) {
  if (random.below(2) == 0) return glm::translate(Mat4(1), unit * random.on_grid(4, 0.5)) * scaled(unit);
  const Vec3 offset = unit * random.in_cube(4);
  const double angle = random.between(0, 6);
  const Vec3 axis = random.in_cube(1) + Vec3(0, 0, 1.5);
  const Vec3 factors = unit * (Vec3(0.3) + 0.7 * glm::abs(random.in_cube(1)));
  return glm::translate(Mat4(1), offset) * glm::rotate(Mat4(1), angle, axis) * glm::scale(Mat4(1), factors);
}

inline Shape dialect_shape(Random& random) {
  Bounds below = Bounds::everything();
  below.min.y = 0;
  below.max.y = 1;
  switch (random.below(7)) {
    case 0: {
      const Vec3 point = random.on_grid(4, 0.5);
      return Plane(point, random.in_cube(1) + Vec3(0, 0, 1.5));
    }
    case 1:
      return Plane(Vec3(0), Vec3(0, 0, 1));
    case 2:
      return Torus(1, random.between(0.1, 1.2));
    case 3:
      return Tube{};
    case 4:
      return Quadric({1, 1, -1, 0, 0, 0, 0, 0, 0, -1});
    case 5:
      return Quadric({1, -1, 0, 0, 0, 0, 0, 0, -1, 0});
    default:
      return Quadric({1, 0, 1, 0, 0, 0, 0, -1, 0, 0}, below,
                     {Vec3(-1.001, 0, -1.001), Vec3(1.001, 1, 1.001)});
  }
}

// `size` objects of random_scene(), and one of the dialects' to every four, at least one.
inline Scene endless_scene(Random& random, int size, double unit = 1) {
  Scene scene = random_scene(random, size, unit);
  for (int i = 0; i < 1 + size / 4; ++i) {
    const Mat4 place = endless_place(random, unit);
    add(scene, i == 0 ? Shape(Plane(Vec3(0), Vec3(0, 0, 1))) : dialect_shape(random), place, Material{});
  }
  return scene;
}

}  // namespace trace::test
