// Whole pictures of scenes made by hand.
#pragma once

#include "rendering/pixel.hpp"
#include "rendering/render.hpp"
#include "tests/support/scene_make.hpp"

namespace trace::test {

inline Rendered rendered(const Scene& scene, const RenderOptions& options) {
  const SceneTree tree(scene);
  Progress progress;
  return render(scene, tree, options, progress);
}

// The red byte of a pixel; j counts from the bottom.
inline int red(const Image& image, int i, int j) {
  return pixel(image, i, j)[0];
}

// The camera of the reference's picture cases.
inline Camera usual_camera() {
  Camera camera;
  camera.eye = {0, 0, 5};
  camera.set_fov(45);
  return camera;
}

// A camera above a white half-plane x < `edge`, whose picture has the window from -1/2 to 1/2 at z = 0.
inline Scene half_white(double edge) {
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  add(scene, Square{}, moved(edge - 1, 0, 0) * scaled(2, 2, 1), emissive(Rgb(1)));
  return scene;
}

}  // namespace trace::test
