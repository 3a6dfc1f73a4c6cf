// Reflected rays of docs/language.md section 6.
#include "tests/support/constants.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("a mirror shows what is in its direction, times its colour, from depth 1 on") {
  const Rgb kr(0.5, 0.25, 0.125);
  Scene scene;
  add(scene, Square{}, turned(pi / 4, 0, 1, 0) * scaled(3), reflective(kr));
  add(scene, Sphere{}, moved(5, 0, 0), emissive(Rgb(1)));
  CHECK(seen(scene, 0) == Rgb(0));
  CHECK(seen(scene, 1) == near(kr));
  CHECK(seen(scene, 7) == near(kr));
  scene.materials[0].values = specular(kr, 0);
  CHECK(seen(scene, 1) == Rgb(0));  // a specular colour is no mirror
}

TEST_CASE("between two mirrors the depth is the number of bounces") {
  // refl_two: 0.1 + 0.5 (0.2 + 1 (0.1 + 0.5 (0.2 + ...))), red from one mirror, green from the other.
  Scene scene;
  add(scene, Square{}, scaled(3), emissive({0.1, 0, 0}) + reflective(Rgb(0.5)));
  add(scene, Square{}, moved(0, 0, 6) * scaled(3), emissive({0, 0.2, 0}) + reflective(Rgb(1)));
  const Rgb by_depth[] = {{0.1, 0, 0},      {0.1, 0.1, 0},     {0.15, 0.1, 0},    {0.15, 0.15, 0},
                          {0.175, 0.15, 0}, {0.175, 0.175, 0}, {0.1875, 0.175, 0}};
  for (int depth = 0; depth < 7; ++depth) CHECK(seen(scene, depth) == near(by_depth[depth]));
  CHECK(traced(scene, from_front(), 5).rays.reflected == 5);
}

TEST_CASE("a negative or large reflection is used as it is") {
  Scene scene;
  add(scene, Square{}, at_origin(), emissive(Rgb(1)) + reflective({-0.5, 3, 0}));
  surround(scene, {255, 255, 255});
  CHECK(seen(scene, 1) == near(0.5, 4, 1));
}

TEST_CASE("an opaque surface mirrors on its inside too, unless internal reflection is off") {
  // 0.1 + 0.5 * 0.1 + ...; blue with a reflection of 1.
  Scene scene;
  add(scene, Sphere{}, at_origin(), emissive(Rgb(0.1)) + reflective({0.5, 0.5, 1}));
  const Ray inside{Vec3(0), Vec3(0, 0, -1)};
  CHECK(seen(scene, inside, 0) == near(0.1, 0.1, 0.1));
  CHECK(seen(scene, inside, 1) == near(0.15, 0.15, 0.2));
  CHECK(seen(scene, inside, 2) == near(0.175, 0.175, 0.3));
  ShadingOptions options;
  options.internal_reflection = false;
  CHECK(seen(scene, inside, 2, options) == near(0.1, 0.1, 0.1));
}

TEST_CASE("inside glass a reflection is attenuated by kt to the way it comes") {
  // refl_inside_trans: each bounce crosses 2, so 0.1 + kr 0.8^2 (0.1 + ...); the refracted rays see nothing.
  Scene scene;
  add(scene, Sphere{}, at_origin(), emissive(Rgb(0.1)) + reflective({0.5, 0.5, 1}) + transmissive(Rgb(0.8)));
  const Ray inside{Vec3(0), Vec3(0, 0, -1)};
  CHECK(seen(scene, inside, 1) == near(0.132, 0.132, 0.164));
  CHECK(seen(scene, inside, 2) == near(0.1 + 0.32 * 0.132, 0.1 + 0.32 * 0.132, 0.1 + 0.64 * 0.164));
  ShadingOptions options;
  options.internal_reflection = false;
  CHECK(seen(scene, inside, 2, options) == near(0.1, 0.1, 0.1));
}

TEST_CASE("internal reflection is a matter of the side, not of the material: outside nothing changes") {
  Scene scene;
  add(scene, Sphere{}, at_origin(), reflective(Rgb(0.5)));
  surround(scene, {255, 255, 255});
  ShadingOptions options;
  options.internal_reflection = false;
  CHECK(seen(scene, 1, options) == near(Vec3(0.5)));
}

TEST_CASE("reflected rays do not see the backs of mesh faces, unless culling is off") {
  Scene scene;
  add(scene, Square{}, at_origin(), reflective(Rgb(1)));
  // Behind the viewer; from the mirror its back is seen.
  add(scene, front_triangle(), moved(0, 0, 8), emissive(Rgb(1)));
  CHECK(seen(scene, 1) == Rgb(0));
  ShadingOptions options;
  options.backface_culling = false;
  CHECK(seen(scene, 1, options) == near(Vec3(1)));
}
