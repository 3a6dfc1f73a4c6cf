// Colours that are infinite or undefined: where they come from and what they spread to.
#include "shading/shadow.hpp"
#include "tests/support/constants.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

namespace {

const double no_number = std::numeric_limits<double>::quiet_NaN();

// Faces in 0, 51, 102, ... of grey; all alike.
void number_faces(Scene& scene) {
  std::vector<Texture> faces;
  for (int face = 0; face < 6; ++face) {
    const auto grey = static_cast<std::uint8_t>(51 * face);
    faces.emplace_back(Image{1, 1, {grey, grey, grey}});
  }
  scene.cube_map = CubeMap(std::move(faces));
}

// Something of each shape around the origin, all white.
Scene shapes() {
  Scene scene;
  const Material white = emissive(Rgb(1));
  add(scene, Sphere{}, at_origin(), white);
  add(scene, Box{}, at_origin(), white);
  add(scene, Square{}, at_origin(), white);
  add(scene, Cylinder{}, at_origin(), white);
  add(scene, Cone(1, 0, 1, true), at_origin(), white);
  add(scene, front_triangle(), at_origin(), white);
  return scene;
}

}  // namespace

TEST_CASE("a ray without a direction hits nothing and sees a corner of the cube map") {
  Scene scene = shapes();
  const Vec3 origin = GENERATE(Vec3(0), Vec3(0, 0, 5), Vec3(0.2, 0.1, 0));
  const Vec3 none = GENERATE(Vec3(0), Vec3(-0.0), Vec3(no_number), Vec3(infinity, no_number, no_number),
                             Vec3(0, 0, infinity));
  CHECK(seen(scene, {origin, none}, 3) == Rgb(0));
  number_faces(scene);
  const Traced corner = traced(scene, {origin, none}, 3);
  CHECK(corner.color == near(Vec3(1)));  // negz
  CHECK(corner.rays.total() == 1);
  CHECK(seen(scene, {origin, Vec3(no_number, no_number, -infinity)}, 3) == near(Vec3(0.8)));  // posz
}

TEST_CASE("a ray from nowhere hits nothing") {
  const Vec3 origin = GENERATE(Vec3(infinity, 0, 0), Vec3(no_number), Vec3(0, 0, -infinity));
  CHECK(seen(shapes(), {origin, Vec3(0, 0, -1)}, 3) == Rgb(0));
}

TEST_CASE("an undefined channel of what is mirrored or refracted is undefined in the whole, times 0 too") {
  // The glass square before black is undefined in green.
  Scene scene;
  add(scene, Square{}, at_origin(), emissive(Rgb(0.25)) + transmissive({0.5, 0, 1}));
  add(scene, Square{}, moved(0, 0, 3), emissive(Rgb(0.5)) + transmissive(Rgb(1)));
  const Traced through = traced(scene, from_front(), 2);
  CHECK(through.undefined == Channels(1));
  CHECK(through.color == near(0.75, 0, 0.75));
  // A mirror that shows nothing of green shows it undefined all the same.
  Scene mirrored;
  add(mirrored, Square{}, at_origin(), emissive(Rgb(0.25)) + reflective({1, 0, 0}));
  add(mirrored, Square{}, moved(0, 0, 9), emissive(Rgb(0.5)) + transmissive({0.5, 0, 0}));
  const Traced reflection = traced(mirrored, from_front(), 2);
  CHECK(reflection.undefined == (Channels(1) | Channels(2)));
  CHECK(reflection.color == near(0.75, 0, 0));
}

TEST_CASE(
    "a negative shininess is infinite where the highlight's cosine is 0, and undefined without a colour") {
  Scene scene;
  add(scene, Square{}, at_origin(), diffuse(Rgb(0.5)) + specular({1, 0, -1}, -2));
  // From the side, seen from the same side: R.V < 0.
  scene.lights = {directional({-0.8, 0, -0.6})};
  const Traced slanting = traced(scene, ray({4, 0, 3}, {-0.8, 0, -0.6}));
  CHECK(slanting.color.x == infinity);
  CHECK(slanting.color.z == -infinity);
  CHECK(slanting.undefined == Channels(1));
  // Where the cosine is not 0 it is a number: R.V = 1 straight from above.
  scene.lights = {directional({0, 0, -1})};
  CHECK(seen(scene) == near(1.5, 0.5, -0.5));
}

TEST_CASE("two lights of infinite and opposite light leave nothing defined") {
  Scene scene;
  add(scene, Square{}, at_origin(), specular({1, 1, 0.5}, -2));
  scene.lights = {directional({-0.8, 0, -0.6}), directional({-0.8, 0, -0.6}, {-1, 1, -0.5})};
  const Traced both = traced(scene, ray({4, 0, 3}, {-0.8, 0, -0.6}));
  CHECK(both.undefined == (Channels(0) | Channels(2)));
  CHECK(both.color == Rgb(0, infinity, 0));
}

TEST_CASE(
    "a shadow through negative glass is undefined for a broken thickness, even of light that is not "
    "reflected") {
  Scene scene;
  add(scene, Box{}, moved(0, 0, 4) * scaled(1, 1, 0.5), transmissive({-0.5, 0.25, 1}));
  scene.shadow_may_be_undefined = true;  // as the builder says of such a material
  const SceneTree tree(scene);
  RayCounts counts;
  const PartialRgb left = shadow_attenuation(scene, tree, {}, {Vec3(0), Vec3(0, 0, 1)}, infinity, counts);
  CHECK(left.undefined == Channels(0));
  CHECK(left.value == near(0, 0.5, 1));
  add(scene, Square{}, at_origin(), emissive(Rgb(0.25)) + diffuse({0, 1, 1}));
  scene.lights = {directional({0, 0, -1})};
  const Traced lit = traced(scene, ray({0, 0, 2}, {0, 0, -1}));
  CHECK(lit.undefined == Channels(0));
  CHECK(lit.color == near(0, 0.75, 1.25));
}

TEST_CASE("transmission beyond all numbers is infinite, and undefined where there is nothing to transmit") {
  Scene scene;
  add(scene, Square{}, moved(0, 0, -4) * scaled(20, 20, 1), emissive({1, 0, -1}));
  add(scene, Box{}, scaled(2), transmissive({1e300, 1e300, 1e300}));
  const Traced huge = traced(scene, from_front(), 3);
  CHECK(huge.color == Rgb(infinity, 0, -infinity));
  CHECK(huge.undefined == Channels(1));
}
