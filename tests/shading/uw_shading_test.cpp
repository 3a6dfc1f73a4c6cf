// How light is computed by the rules of uw; numbers by hand.
#include "shading/shadow.hpp"
#include "tests/support/constants.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

namespace {

Scene uw_scene() {
  Scene scene;
  scene.rules = rules_of(parser::Dialect::uw);
  return scene;
}

Scene utexas_scene() {
  return {};
}

const Rgb clear_glass(0.5, 0.25, 0.75);

// A square with a highlight seen at right angles, lit at 60 degrees.
Scene shining(Scene scene) {
  add(scene, Square{}, at_origin(), specular(Rgb(0.5), 10));
  scene.lights.emplace_back(directional({-std::sqrt(0.75), 0, -0.5}));
  return scene;
}

Rgb light_left(Scene scene, const Shape& shape, const Mat4& place) {
  add(scene, shape, place, transmissive(clear_glass));
  const SceneTree tree(scene);
  RayCounts counts;
  return shadow_attenuation(scene, tree, {}, {Vec3(0), Vec3(0, 0, 1)}, infinity, counts).value;
}

Rgb through_glass(Scene scene, const Shape& shape, int depth) {
  add(scene, shape, at_origin(), transmissive(clear_glass));
  surround(scene, {255, 255, 255});
  return seen(scene, depth);
}

// From the middle of a glowing box of glass that mirrors, to its wall and back to the other.
Rgb seen_inside(Scene scene) {
  add(scene, Box{}, at_origin(), emissive(Rgb(0.5)) + transmissive(clear_glass) + reflective(Rgb(0.25)));
  return seen(scene, {Vec3(0), Vec3(0, 0, -1)}, 1);
}

}  // namespace

TEST_CASE("meshes are seen and lit from behind in uw, and not at all in utexas") {
  const auto lit = [](Scene scene) {
    add(scene, back_triangle(), at_origin(), diffuse({0.5, 0.25, 1}));
    scene.lights.emplace_back(directional({0, -0.6, -0.8}));
    return seen(scene);
  };
  CHECK(lit(uw_scene()) == near(0.4, 0.2, 0.8));
  CHECK(lit(utexas_scene()) == Rgb(0));
}

TEST_CASE("light behind a surface that transmits adds nothing in uw, and as from before it in utexas") {
  const auto lit = [](Scene scene) {
    add(scene, Square{}, at_origin(), diffuse(Rgb(0.5)) + transmissive(clear_glass));
    scene.lights.emplace_back(directional({0, 0, 1}));
    return seen(scene);
  };
  CHECK(lit(uw_scene()) == Rgb(0));
  CHECK(lit(utexas_scene()) == near(Vec3(0.5)));
}

TEST_CASE("highlights are by the direction halfway to the light in uw, and by the mirrored one in utexas") {
  CHECK(seen(shining(uw_scene())) == near(Vec3(0.5 * std::pow(std::sqrt(0.75), 10))));  // 30 degrees
  CHECK(seen(shining(utexas_scene())) == near(Vec3(0.5 * std::pow(0.5, 10))));          // 60 degrees
}

TEST_CASE("a highlight with shininess 0 is on the lit side alone in uw") {
  const auto shown = [](double z) {
    Scene scene = uw_scene();
    add(scene, Square{}, at_origin(), specular(Rgb(0.5), 0) + transmissive(Rgb(1)));
    scene.lights.emplace_back(directional({0, 0, z}));
    return seen(scene);
  };
  CHECK(shown(-1) == near(Vec3(0.5)));
  CHECK(shown(1) == Rgb(0));
}

TEST_CASE("shadows lose kt at each surface in uw, and by the way inside in utexas") {
  const Mat4 thick = moved(0, 0, 4) * scaled(1, 1, 3);
  CHECK(light_left(uw_scene(), Box{}, thick) == near(clear_glass * clear_glass));
  CHECK(light_left(utexas_scene(), Box{}, thick) == near(clear_glass * clear_glass * clear_glass));
  CHECK(light_left(uw_scene(), Square{}, thick) == near(clear_glass));
  CHECK(light_left(utexas_scene(), Square{}, thick) == Rgb(1));
}

TEST_CASE("what is seen through a surface is multiplied by kt in uw, once into a body and once out of it") {
  CHECK(through_glass(uw_scene(), Square{}, 1) == near(clear_glass));
  CHECK(through_glass(uw_scene(), Box{}, 2) == near(clear_glass * clear_glass));
  // In utexas a miss divides by kt, and the way through a box of edge one multiplies by it.
  CHECK(through_glass(utexas_scene(), Square{}, 1) == near(1.0 / clear_glass));
  CHECK(through_glass(utexas_scene(), Box{}, 2) == near(clear_glass));
}

TEST_CASE("what is mirrored inside glass loses nothing on its way in uw, and by its length in utexas") {
  CHECK(seen_inside(uw_scene()) == near(Vec3(0.5 + 0.25 * 0.5)));
  CHECK(seen_inside(utexas_scene()) == near(0.5 + 0.25 * 0.5 * clear_glass));
}

TEST_CASE("in uw a least contribution ends paths behind surfaces whose kt is small") {
  Scene scene = uw_scene();
  add(scene, Square{}, at_origin(), transmissive(Rgb(0.1)));
  add(scene, Square{}, moved(0, 0, -1), transmissive(Rgb(0.1)));
  ShadingOptions options;
  CHECK(traced(scene, from_front(), 5, options).rays.refracted == 2);
  options.least_contribution = 0.05;
  CHECK(traced(scene, from_front(), 5, options).rays.refracted == 1);
}

TEST_CASE(
    "air has the index 1.0003 in uw, so that a body of that index bends nothing and one of index 1 does") {
  // A speck behind the edge of a ball, half as wide as what the small index turns the ray aside by there:
  // 2 (1 - 1 / 1.0003) tan(asin 0.6) over a way of 4.2.
  const auto speck = [](Scene scene, double index) {
    add(scene, Sphere{}, at_origin(), transmissive(Rgb(1), index));
    add(scene, Sphere{}, moved(0.6, 0, -5) * scaled(0.001), emissive(Rgb(1)));
    return seen(scene, {{0.6, 0, 5}, {0, 0, -1}}, 2).x;
  };
  CHECK(speck(uw_scene(), 1.0003) == 1);
  CHECK(speck(uw_scene(), 1) == 0);
  CHECK(speck(utexas_scene(), 1) == 1);
}

TEST_CASE("a ray that leaves a surface meets nothing nearer than 1e-5 in uw") {
  const auto least_t = [](Scene scene) {
    add(scene, Square{}, at_origin(), Material{});
    const SceneTree tree(scene);
    const Hit hit = tree.closest(from_front(), false);
    return Surface(scene, from_front(), hit, true).leaving({0, 0, 1}).least_t;
  };
  CHECK(least_t(uw_scene()) == 1e-5);
  CHECK(least_t(utexas_scene()) < 1e-9);
}
