// Scenes for the tests of sampling, and a frame over a scene for parts of the renderer that need one.
#pragma once

#include "rendering/film.hpp"
#include "rendering/frame_renderer.hpp"
#include "tests/support/scene_picture.hpp"
#include "tests/support/scene_random.hpp"

namespace trace::test {

// A scene's frame, which refers to what lies beside it here.
class Stage {
 public:
  Stage(const Scene& scene, const RenderOptions& options)
      : tree_(scene),
        options_(options),
        frame_(scene, tree_, options_, static_cast<int>(picture_height(scene, options.width)),
               threads_or_all(options.threads), progress_) {}

  FrameRenderer& frame() { return frame_; }
  const SceneTree& tree() const { return tree_; }
  Film film() const { return {frame_.width(), frame_.height(), true}; }

 private:
  SceneTree tree_;
  RenderOptions options_;
  Progress progress_;
  FrameRenderer frame_;
};

inline RenderOptions sampling_options(int width, int depth = 5, int threads = 2) {
  RenderOptions options;
  options.width = width;
  options.depth = depth;
  options.threads = threads;
  options.keep_colors = true;
  return options;
}

// With 16 x 16 samples in each pixel: the truth of these tests.
inline ColorImage finely_sampled(const Scene& scene, RenderOptions options) {
  options.keep_colors = true;
  options.sampling = {16, 0, 8};
  return rendered(scene, options).colors;
}

// One colour all over.
inline Scene flat_scene(const Rgb& color) {
  Scene scene;
  scene.camera.eye = {0, 0, 1};
  add(scene, Square{}, scaled(9, 9, 1), emissive(color));
  return scene;
}

// Edges, shadows, a mirror and glass.
inline Scene mixed_scene() {
  Scene scene;
  scene.camera = usual_camera();
  scene.ambient = Rgb(0.3);
  scene.lights = {directional({-1, -2, -1.5}, Rgb(0.7)), PointLight{Rgb(4), Vec3(2, 3, 3)}};
  add(scene, Box{}, moved(0, -1.6, 0) * scaled(9, 0.4, 9), diffuse({0.7, 0.6, 0.5}) + ambient(Rgb(0.4)));
  add(scene, Sphere{}, moved(-1.1, -0.6, -0.5) * scaled(0.8),
      diffuse(Rgb(0.1)) + specular(Rgb(0.4), 30) + reflective(Rgb(0.7)));
  add(scene, Sphere{}, moved(0.8, -0.7, 0.8) * scaled(0.6),
      transmissive({0.9, 0.95, 0.9}, 1.4) + reflective(Rgb(0.1)));
  add(scene, Box{}, moved(0.6, 0.4, -1.5) * turned(0.6, 1, 2, 0.5),
      diffuse({0.9, 0.2, 0.1}) + ambient(Rgb(0.5)));
  add(scene, front_triangle(), moved(-0.3, 1, -1) * turned(0.4, 0, 0, 1) * scaled(0.6),
      emissive({0.2, 0.6, 0.9}));
  return scene;
}

// Objects of all kinds and materials anywhere, under two lights.
inline Scene random_materials_scene(std::uint32_t seed) {
  Random random(seed);
  Scene scene = random_scene(random, 12);
  for (MappedMaterial& m : scene.materials) {
    const double matte = random.between(0.2, 1), glow = random.between(0, 0.2);
    Material own = diffuse({matte, 0.5, 1 - matte}) + emissive(Rgb(glow));
    switch (random.below(3)) {
      case 0:
        own = own + reflective(Rgb(0.5));
        break;
      case 1:
        own = own + transmissive(Rgb(0.6), 1.2);
        scene.has_transmissive_objects = true;
        break;
      default:
        break;
    }
    m.values = own;
  }
  scene.lights = {directional({-1, -1, -2}), PointLight{Rgb(3), Vec3(2, 5, 9)}};
  scene.camera.eye = {0, 0, 14};
  return scene;
}

// Two walls that face each other, with the camera between: at depth d a channel is g (1 + k + ... + k^d),
// each wall glowing with g and mirroring k.
inline Scene facing_mirrors(double glow, double mirrored) {
  Scene scene;
  const Material wall = emissive(Rgb(glow)) + reflective(Rgb(mirrored));
  add(scene, Square{}, moved(0, 0, -1) * scaled(1e6, 1e6, 1), wall);
  add(scene, Square{}, moved(0, 0, 1) * scaled(1e6, 1e6, 1), wall);
  return scene;
}

}  // namespace trace::test
