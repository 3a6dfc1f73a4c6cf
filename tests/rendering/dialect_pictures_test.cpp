// Pictures with what dialects add: packets and single rays, and any number of threads, draw the same.
#include <catch2/catch.hpp>

#include <stdexcept>

#include "precision/arithmetic.hpp"
#include "tests/support/scene_everything.hpp"

using namespace trace;
using namespace trace::test;

namespace {

Scene room_of_dialects() {
  Scene scene;
  scene.camera = usual_camera();
  add(scene, Square{}, moved(0, -1, 0) * turned(-1.5, 1, 0, 0) * scaled(6), diffuse({0.8, 0.7, 0.6}));
  add(scene, Sphere{}, moved(-0.6, -0.3, 0.5) * scaled(0.5), diffuse(Rgb(0.5)) + specular(Rgb(0.4), 20));
  add(scene, Sphere{}, moved(0.7, -0.2, -0.4) * scaled(0.6), transmissive({0.6, 0.9, 0.8}, 1.3));
  add(scene, Box{}, moved(0, 1, 0) * turned(0.7, 1, 2, 3), diffuse(Rgb(0.3)) + reflective(Rgb(0.5)));
  SpotLight spot{};
  spot.color = Rgb(1, 0.8, 0.6);
  spot.position = Vec3(1, 3, 3);
  spot.beam.direction = glm::normalize(Vec3(-1, -3, -3));
  spot.beam.cosine_of_edge = 0.8;
  spot.beam.cosine_of_full = 0.95;
  spot.beam.exponent = 3;
  scene.lights.push_back(spot);
  SpotLight shaped{};
  shaped.color = Rgb(0.3, 0.5, 0.9);
  shaped.position = Vec3(-2, 2, 2);
  shaped.quadratic = 0.1f;
  shaped.beam.direction = glm::normalize(Vec3(2, -2, -2));
  shaped.beam.reach = 12;
  shaped.beam.flaps = Flaps{Vec3(-1, -2, -2), Vec3(1, 2, 1), Flaps::Outline::box};
  const Vec3 x = glm::normalize(Vec3(1, 0, 1));
  shaped.beam.aperture = Aperture(3, true, 0.8, x, glm::cross(x, shaped.beam.direction));
  shaped.beam.aperture_distance = 2;
  scene.lights.push_back(shaped);
  AreaLight area{};
  area.color = Rgb(0.6);
  area.position = Vec3(-1, 4, 1);
  area.u = Vec3(2, 0, 0);
  area.v = Vec3(0, 0, 2);
  scene.lights.push_back(area);
  Fog fog;
  fog.color = Rgb(0.7, 0.8, 0.9);
  fog.start = 3;
  fog.end = 30;
  scene.fog = fog;
  return scene;
}

RenderOptions small_picture() {
  RenderOptions options;
  options.width = 40;
  options.depth = 3;
  options.threads = 1;
  options.shading.light_samples = 2;
  return options;
}

Rendered drawn(const Scene& scene, const RenderOptions& options) {
  const SceneTree tree(scene);
  Progress progress;
  return render(scene, tree, options, progress);
}

}  // namespace

TEST_CASE("packets draw lights and fog of dialects as single rays do, needed or not") {
  const NeededAndAll result = needed_and_all(room_of_dialects(), small_picture());
  CHECK(result.needed.rays.shadow > 0);
}

TEST_CASE("packets draw orthographic pictures as single rays do") {
  Scene scene = room_of_dialects();
  scene.camera.orthographic_height = 5;
  needed_and_all(scene, small_picture());
  RenderOptions sampled = small_picture();
  sampled.sampling.grid = 2;
  needed_and_all(scene, sampled);
}

TEST_CASE("packets draw each rule of transmissive shadows as single rays do") {
  RenderOptions options = small_picture();
  options.shading.transmissive_shadows =
      GENERATE(TransmissiveShadows::distance, TransmissiveShadows::surface, TransmissiveShadows::none);
  needed_and_all(room_of_dialects(), options);
}

TEST_CASE("packets leave materials of dialects to single rays") {
  Scene scene = room_of_dialects();
  scene.materials[1].blinn_phong = true;
  scene.materials[2].absorb = Rgb(0.5, 0.1, 0);
  scene.materials[3].glossiness = 0.1;
  needed_and_all(scene, small_picture());
}

TEST_CASE("a picture with lights of dialects is the same for any number of threads") {
  Scene scene = room_of_dialects();
  scene.materials[3].glossiness = 0.1;
  RenderOptions options = small_picture();
  const Rendered one = drawn(scene, options);
  options.threads = 3;
  const Rendered three = drawn(scene, options);
  CHECK(three.image.rgb == one.image.rgb);
  CHECK(three.rays == one.rays);
}

TEST_CASE("an orthographic picture shows things equally large at any distance") {
  Scene scene;
  scene.camera = usual_camera();
  scene.camera.orthographic_height = 4;
  add(scene, Square{}, moved(-1.03, 0.02, 1), emissive(Rgb(1)));
  add(scene, Square{}, moved(1.03, 0.02, -30), emissive(Rgb(1)));
  const Rendered picture = drawn(scene, small_picture());
  std::size_t left = 0, right = 0;
  for (int y = 0; y < picture.image.height; ++y) {
    for (int x = 0; x < picture.image.width; ++x) {
      const bool bright = pixel(picture.image, x, y)[0] == 255;
      (x < picture.image.width / 2 ? left : right) += bright;
    }
  }
  CHECK(left == 100);
  CHECK(right == 100);
}

TEST_CASE("other arithmetics refuse what the course's language does not have") {
  const Scene scene = room_of_dialects();
  CHECK_THROWS_AS(render_in(Arithmetic::single, scene, small_picture(), 1), std::invalid_argument);
}
