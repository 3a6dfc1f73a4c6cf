// Refracted rays of docs/language.md section 6.
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

namespace {

const Rgb glass_kt(0.5, 0.25, 0.9);

// A white wall at z = -4, and before it `shape` twice its size, of index one.
Scene before_wall(const Shape& shape) {
  Scene scene;
  add(scene, Square{}, moved(0, 0, -4) * scaled(20, 20, 1), emissive(Rgb(1)));
  add(scene, shape, scaled(2), transmissive(glass_kt));
  return scene;
}

}  // namespace

TEST_CASE("glass is coloured by kt to the power of its thickness, from depth 2 on") {
  const Scene scene = before_wall(Box{});
  CHECK(seen(scene, 0) == Rgb(0));
  CHECK(seen(scene, 1) == Rgb(0));  // only up to the far face, which emits nothing
  CHECK(seen(scene, 2) == near(glass_kt * glass_kt));
  CHECK(seen(scene, 3) == near(glass_kt * glass_kt));
  CHECK(traced(scene, from_front(), 9).rays.refracted == 2);
}

TEST_CASE("a transmissive square colours everything up to the next surface behind it") {
  CHECK(seen(before_wall(Square{}), 1) == near(glm::pow(glass_kt, Rgb(4))));
}

TEST_CASE("what the far face of glass emits is attenuated too, and the near face keeps its own light whole") {
  // trans_emissive: 0.1 + kt^2 0.1.
  Scene scene;
  add(scene, Box{}, scaled(2), emissive(Rgb(0.1)) + transmissive(glass_kt));
  CHECK(seen(scene, 3) == near(Rgb(0.1) + glass_kt * glass_kt * 0.1));
}

TEST_CASE("transmission above one is used as it is") {
  Scene scene;
  add(scene, Square{}, moved(0, 0, -4) * scaled(20, 20, 1), emissive(Rgb(0.1)));
  add(scene, Box{}, scaled(2), transmissive({2, 1, 1.5}));
  CHECK(seen(scene, 3) == near(0.4, 0.1, 0.225));
}

TEST_CASE("light is bent by Snell's law on the way in and out") {
  // Index 2: sin 0.6 becomes 0.3 inside. The box from z = 0 to -1 shifts the ray from x = 0 to x = 0.3 /
  // sqrt(0.91); out again it runs on parallel to itself, another 0.75 per unit of depth, to a wall at z = -3.
  Scene scene;
  add(scene, Box{}, moved(0, 0, -0.5) * scaled(10, 10, 1), transmissive(Rgb(1), 2));
  const double x = 0.3 / std::sqrt(0.91) + 2 * 0.75;
  add(scene, Square{}, moved(x, 0, -3) * scaled(1e-6), emissive(Rgb(1)));
  const Ray slanting{{-0.6 * 5, 0, 0.8 * 5}, {0.6, 0, -0.8}};
  CHECK(seen(scene, slanting, 2) == near(1, 1, 1, 1e-6));
  CHECK(seen(scene, slanting, 1) == Rgb(0));
  scene.materials[0].values.index = Rgb(1.9);
  CHECK(seen(scene, slanting, 2) == Rgb(0));
}

TEST_CASE("total internal reflection adds nothing of its own, the mirror of the surface goes on") {
  // From inside, sin = 0.8 and index 1.5: 1 - 2.25 * 0.64 < 0.
  Scene scene;
  add(scene, Box{}, scaled(10, 10, 2), emissive(Rgb(0.1)) + transmissive(Rgb(1), 1.5));
  surround(scene, {255, 255, 255});
  const Ray inside{Vec3(0), Vec3(0.8, 0, 0.6)};
  CHECK(seen(scene, inside, 1) == near(Vec3(0.1)));
  CHECK(traced(scene, inside, 1).rays.refracted == 0);
  scene.materials[0].values.reflective = Rgb(0.5);
  CHECK(seen(scene, inside, 1) == near(Vec3(0.15)));
  scene.materials[0].values.index = Rgb(1.2);  // 1 - 1.44 * 0.64 > 0: out it goes
  CHECK(seen(scene, inside, 1) == near(Vec3(1.15)));
}

TEST_CASE("a refracted ray that meets nothing counts as -1 long") {
  // kt^-1: on black it shows only where kt is 0, as 0 / 0.
  Scene scene;
  add(scene, Square{}, at_origin(), emissive(Rgb(0.2)) + transmissive({0.5, 0, 1}));
  const Traced black = traced(scene, from_front(), 1);
  CHECK(black.color == near(0.2, 0, 0.2));
  CHECK(black.undefined == Channels(1));
  CHECK(seen(scene, 0) == near(Vec3(0.2)));
  // With a cube map of 100/255: 100/255 / kt.
  Scene open;
  add(open, Square{}, at_origin(), transmissive({0.5, 0.001, 1}));
  surround(open, {100, 100, 100});
  CHECK(seen(open, 2) == near(200 / 255.0, 100 / 0.255, 100 / 255.0, 1e-9));
}

TEST_CASE("every ray that meets nothing sees the cube map, at any depth") {
  Scene scene;
  surround(scene, {51, 102, 255});
  CHECK(seen(scene, 0) == near(0.2, 0.4, 1));
  add(scene, Sphere{}, at_origin(), reflective({0.5, 1, 0}));
  CHECK(seen(scene, 0) == Rgb(0));
  CHECK(seen(scene, 1) == near(0.1, 0.4, 0));
}

TEST_CASE("on leaving glass nothing is attenuated") {
  Scene scene;
  add(scene, Sphere{}, at_origin(), transmissive({0.5, 0.25, 1}));
  surround(scene, {100, 100, 100});
  CHECK(seen(scene, {Vec3(0), Vec3(0, 0, -1)}, 1) == near(Vec3(100 / 255.0)));
}

TEST_CASE("refracted rays see the backs of mesh faces, primary ones do not unless culling is off") {
  Scene scene;
  add(scene, back_triangle(), at_origin(), emissive({0.2, 0.4, 0.6}));
  CHECK(seen(scene, 5) == Rgb(0));
  ShadingOptions options;
  options.backface_culling = false;
  CHECK(seen(scene, 5, options) == near(0.2, 0.4, 0.6));
  add(scene, Box{}, moved(0, 0, 2), transmissive(Rgb(1)));
  CHECK(seen(scene, 5) == near(0.2, 0.4, 0.6));  // refracted even after it has left the glass
}

TEST_CASE("a reflection inside a mesh of glass flies out through its far side, which is culled for it") {
  // cull_slab: front face at z = 1, back face at z = -1. 0.1 + 0.8^2 0.1 of the back face, and no more at any
  // depth.
  Scene scene;
  Mesh slab;
  slab.points = {{-3, -3, 1}, {3, -3, 1}, {0, 3, 1}, {-3, -3, -1}, {3, -3, -1}, {0, 3, -1}};
  slab.faces = {{0, 1, 2}, {3, 5, 4}};
  add(scene, slab, at_origin(), emissive({0.1, 0.05, 0}) + reflective({0.5, 1, 0}) + transmissive(Rgb(0.8)));
  CHECK(seen(scene, 0) == near(0.1, 0.05, 0));
  const int depth = GENERATE(1, 2, 3, 6);
  CHECK(seen(scene, depth) == near(0.164, 0.082, 0));
}

TEST_CASE("the index is that of the surface hit: nested glasses know nothing of one another") {
  // Straight through; only thicknesses count: 0.9 outside for 0.5, 0.3 for 1 up to its far side, then nothing
  // for the outer's last half.
  Scene scene;
  add(scene, Square{}, moved(0, 0, -2) * scaled(8), emissive(Rgb(1)));
  add(scene, Sphere{}, at_origin(), transmissive(Rgb(0.9), 1.5));
  add(scene, Sphere{}, scaled(0.5), transmissive(Rgb(0.3), 2));
  CHECK(seen(scene, 8) == near(Vec3(std::sqrt(0.9) * 0.3)));
}

TEST_CASE("depth bounds the tree of a surface that both mirrors and transmits") {
  // trans_refl: the numbers of the course's renderer in bytes.
  Scene scene;
  add(scene, Box{}, scaled(2), emissive(Rgb(0.1)) + reflective(Rgb(0.9)) + transmissive({0.5, 0.5, 1}));
  const int red[] = {25, 31, 33, 33, 33, 33}, blue[] = {25, 51, 73, 94, 113, 129};
  for (int depth = 0; depth < 6; ++depth) {
    const Rgb color = seen(scene, depth);
    CHECK(static_cast<int>(255 * color.x) == red[depth]);
    CHECK(static_cast<int>(255 * color.z) == blue[depth]);
  }
}
