// Ray trees as deep as they get.
#include "tests/support/constants.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_picture.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

namespace {

// 32 spheres of glass one in the other, of radius 1, 31/32, ... 1/32, before a white wall.
Scene nested_glass(const Rgb& kt, double index) {
  Scene scene;
  add(scene, Square{}, moved(0, 0, -2) * scaled(20, 20, 1), emissive(Rgb(1)));
  for (int i = 0; i < 32; ++i) add(scene, Sphere{}, scaled(1 - i / 32.0), transmissive(kt, index));
  return scene;
}

// Mirrors that face each other, each with light of its own.
Rgb between_mirrors(const Rgb& kr, int depth) {
  Scene scene;
  add(scene, Square{}, scaled(3), emissive(Rgb(0.25)) + reflective(kr));
  add(scene, Square{}, moved(0, 0, 6) * scaled(3), emissive(Rgb(0.25)) + reflective(kr));
  const Traced result = traced(scene, from_front(), depth);
  CHECK_FALSE(result.undefined.any());
  CHECK(result.rays.reflected == static_cast<std::uint64_t>(depth));
  return result.color;
}

}  // namespace

TEST_CASE("through 32 spheres of glass straight in the middle light is coloured by each once") {
  // 31 shells of 1/32 on entering, the innermost whole, 2/32, and nothing on leaving: kt ^ (33/32).
  const Rgb kt(0.5, 0.25, 0.9);
  const Scene scene = nested_glass(kt, GENERATE(1.0, 1.5));
  const Traced wall = traced(scene, from_front(), 64);
  CHECK(wall.color == near(glm::pow(kt, Rgb(33 / 32.0)), 1e-14));
  CHECK(wall.rays.refracted == 64);
  CHECK(seen(scene, 63) == Rgb(0));
  CHECK(seen(scene, 1000) == wall.color);
}

TEST_CASE(
    "a picture of 32 nested spheres of glass is finite everywhere and the same for any number of threads") {
  Scene scene = nested_glass(Rgb(0.9, 0.8, 0.95), 1.05);
  scene.camera = usual_camera();
  RenderOptions options;
  options.width = 48;
  options.depth = 64;
  options.threads = 1;
  const Rendered one = rendered(scene, options);
  options.threads = 3;
  const Rendered three = rendered(scene, options);
  CHECK(one.image.rgb == three.image.rgb);
  CHECK(one.non_finite.count == 0);
  CHECK(one.rays.refracted > 48 * 48);
  // In the middle all of the wall is seen but what the glass takes: kt ^ (33/32).
  CHECK(red(one.image, 24, 24) == static_cast<int>(255 * std::pow(0.9, 33 / 32.0)));
}

TEST_CASE("between mirrors a thousand bounces add up") {
  CHECK(between_mirrors(Rgb(1, 0, -1), 1000) == Rgb(0.25 * 1001, 0.25, 0.25));
  // The geometric series 0.25 (2^1001 - 1), to the last bit.
  CHECK(between_mirrors(Rgb(2), 1000).x == std::ldexp(0.25, 1001));
}

TEST_CASE(
    "between mirrors that add more light than there are numbers it is infinite, with its sign, never "
    "undefined") {
  // 0.25 - 4 (0.25 - 4 (...)): the last of an even number of bounces makes it positive.
  const Rgb even = between_mirrors(Rgb(4, -4, 0.5), 1000), odd = between_mirrors(Rgb(4, -4, 0.5), 999);
  CHECK(even.x == infinity);
  CHECK(even.y == infinity);
  CHECK(even.z == about(0.5));
  CHECK(odd.x == infinity);
  CHECK(odd.y == -infinity);
}
