// Colours seen in scenes made by hand.
#pragma once

#include "shading/whitted.hpp"
#include "tests/support/scene_make.hpp"
#include "tests/support/scene_rays.hpp"

namespace trace::test {

struct Traced {
  Rgb color;           // 0 where undefined
  Channels undefined;  // channels
  RayCounts rays;
};

inline Traced traced(const Scene& scene, const Ray& ray, int depth = 0, const ShadingOptions& options = {}) {
  const SceneTree tree(scene);
  Traced result;
  const TracedScene world(scene, tree, options);
  const PartialRgb color = WhittedTracer(world, result.rays).trace(ray, depth);
  result.color = color.value;
  result.undefined = color.undefined;
  return result;
}

inline Rgb seen(const Scene& scene, const Ray& ray, int depth = 0, const ShadingOptions& options = {}) {
  return traced(scene, ray, depth, options).color;
}

// From (0, 0, 5) along -z, as the camera of most picture cases looks.
inline Ray from_front() {
  return {{0, 0, 5}, {0, 0, -1}};
}

inline Rgb seen(const Scene& scene, int depth = 0, const ShadingOptions& options = {}) {
  return seen(scene, from_front(), depth, options);
}

// What misses everything is this colour.
inline void surround(Scene& scene, const std::array<std::uint8_t, 3>& color) {
  const Texture face(Image{1, 1, {color[0], color[1], color[2]}});
  scene.cube_map = CubeMap(std::vector<Texture>(6, face));
}

}  // namespace trace::test
