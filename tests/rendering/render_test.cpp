#include "rendering/render.hpp"

#include <algorithm>

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_picture.hpp"
#include "tests/support/scene_random.hpp"

using namespace trace;
using namespace trace::test;

namespace {

Scene busy_scene() {
  Random random(5);
  Scene scene = random_scene(random, 30);
  for (MappedMaterial& m : scene.materials) {
    const double glow = random.between(0, 0.3), matte = random.between(0, 1);
    m.values = emissive(Rgb(glow)) + diffuse(Rgb(matte)) + reflective(Rgb(0.2));
  }
  scene.lights = {directional({-1, -1, -2}), PointLight{Rgb(3), Vec3(2, 5, 9)}};
  scene.camera.eye = {0, 0, 14};
  return scene;
}

}  // namespace

TEST_CASE("a pixel samples its lower left corner") {
  // img_sampling: the square from (0.5, 0) to (1.5, 1) seen from z = 5 with fov 45 in 200 pixels is at
  // x = 1/2 + (0.5 to 1.5) / (5 * 0.828427), y = 1/2 + (0 to 1) / 4.142136: columns 124.14 to 172.43, rows
  // 100 to 148.28 from the bottom; what is lit are the whole numbers among them.
  Scene scene;
  scene.camera = usual_camera();
  add(scene, Square{}, moved(1, 0.5, 0), emissive(Rgb(1)));
  RenderOptions options;
  options.width = 200;
  const Image image = rendered(scene, options).image;
  REQUIRE(image.height == 200);
  int wrong = 0;
  for (int row = 0; row < 200; ++row) {
    for (int column = 0; column < 200; ++column) {
      const bool lit = column >= 125 && column <= 172 && row >= 51 && row <= 99;
      if (image.rgb[3 * static_cast<std::size_t>(200 * row + column)] != (lit ? 255 : 0)) ++wrong;
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("a picture is int(width / aspect + 1/2) high") {
  Scene scene;
  scene.camera.aspect = 1.7;
  CHECK(picture_height(scene, 64) == 38);  // 37.647 + 0.5
  scene.camera.aspect = 2;
  CHECK(picture_height(scene, 5) == 3);  // 2.5 + 0.5
  scene.camera.aspect = 100;
  CHECK(picture_height(scene, 40) == 0);
  scene.camera.aspect = 1e-9;
  CHECK(picture_height(scene, 1000) == Approx(1e12));
  scene.camera.aspect = 1.7;
  RenderOptions options;
  options.width = 64;
  const Image image = rendered(scene, options).image;
  CHECK(image.width == 64);
  CHECK(image.height == 38);
  CHECK(image.rgb.size() == 64 * 38 * 3);
}

TEST_CASE("any number of threads gives the same bytes and the same counts of rays") {
  const Scene scene = busy_scene();
  RenderOptions options;
  options.width = 70;
  options.depth = 3;
  options.antialiasing.enabled = GENERATE(false, true);
  options.blocks.threshold = GENERATE(0, 100);
  options.threads = 1;
  const Rendered one = rendered(scene, options);
  CHECK(std::count(one.image.rgb.begin(), one.image.rgb.end(), 0) < 70 * 70 * 3 - 1000);
  for (const int threads : {2, 3, 7}) {
    options.threads = threads;
    const Rendered many = rendered(scene, options);
    CHECK(many.image.rgb == one.image.rgb);
    CHECK(many.rays.total() == one.rays.total());
    CHECK(many.rays.shadow == one.rays.shadow);
  }
}

TEST_CASE("rays are counted by their kind: one primary a pixel, no shadows without lights") {
  Scene scene = busy_scene();
  RenderOptions options;
  options.width = 20;
  options.depth = 0;
  const RayCounts lit = rendered(scene, options).rays;
  CHECK(lit.primary == 400);
  CHECK(lit.reflected == 0);
  CHECK(lit.refracted == 0);
  CHECK(lit.shadow > 0);
  scene.lights.clear();
  options.depth = 2;
  const RayCounts dark = rendered(scene, options).rays;
  CHECK(dark.shadow == 0);
  CHECK(dark.reflected > 0);
  CHECK(dark.total() == dark.primary + dark.reflected);
}

TEST_CASE("progress ends at the number of pixels, twice that with antialiasing that does anything") {
  const Scene scene = half_white(0);
  const SceneTree tree(scene);
  RenderOptions options;
  options.width = 33;
  options.antialiasing.enabled = GENERATE(false, true);
  options.antialiasing.supersamples = GENERATE(1, 2);
  options.blocks.threshold = GENERATE(0, 50);
  Progress progress;
  render(scene, tree, options, progress);
  const bool refined = options.antialiasing.enabled && options.antialiasing.supersamples > 1;
  CHECK(progress.total == (refined ? 2u : 1u) * 33 * 33);
  CHECK(progress.done == progress.total);
}

TEST_CASE("a picture one pixel small is a picture") {
  RenderOptions options;
  options.width = 1;
  options.antialiasing.enabled = true;
  options.blocks.threshold = GENERATE(0, 50);
  CHECK(rendered(half_white(0), options).image.rgb == std::vector<std::uint8_t>{255, 255, 255});
}

TEST_CASE("an undefined channel of a pixel is black, the others are not") {
  Scene scene;
  scene.camera.eye = {0, 0, 5};
  add(scene, Square{}, scaled(20, 20, 1), emissive(Rgb(0.2)) + transmissive({0.5, 0, 1}));
  RenderOptions options;
  options.width = 2;
  CHECK(rendered(scene, options).image.rgb ==
        std::vector<std::uint8_t>{51, 0, 51, 51, 0, 51, 51, 0, 51, 51, 0, 51});
}
