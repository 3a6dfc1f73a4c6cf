// Random scenes and rays, with many of the coincidences that people's scenes are full of.
#pragma once

#include <random>

#include "acceleration/scene_tree.hpp"
#include "tests/support/scene_make.hpp"

namespace trace::test {

// Numbers that are the same on every machine.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine_()) % n; }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 0x1p32);
  }
  Vec3 in_cube(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
  // Multiples of `step` up to `half` either way.
  Vec3 on_grid(int half, double step) {
    const auto one = [&] {
      return step * (static_cast<int>(below(static_cast<std::uint32_t>(2 * half + 1))) - half);
    };
    return {one(), one(), one()};
  }

 private:
  std::mt19937 engine_;
};

// `size` objects of all kinds; half of them on a grid, upright or turned by quarter turns, so that surfaces
// coincide. All coordinates are multiplied by `unit`.
Scene random_scene(Random& random, int size, double unit = 1);

// A ray at a random scene: from the grid or anywhere, along axes, along diagonals, with zeros and negative
// zeros, or in any direction.
Ray random_ray(Random& random, double unit = 1);

// Every face in turn, without a hierarchy. What MeshTree::closest promises to find.
bool nearest_face(const Mesh& mesh, const Ray& ray, bool cull, LocalHit& hit);

// Every object in turn, without a hierarchy: the exact formulas, the nearest hit, of equal ones the first in
// the file. What SceneTree::closest promises to find.
Hit closest_of_all(const Scene& scene, const Ray& ray, bool cull);

}  // namespace trace::test
