// Shading that dialects add: fog, the half vector, Beer's coefficients, gloss, rules of shadows, soft
// shadows.
#include <catch2/catch.hpp>

#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

namespace {

MappedMaterial with_extras(const Material& values) {
  MappedMaterial result;
  result.values = values;
  return result;
}

// A square at z = 0 that the usual ray hits, lit from in front by a light beside the eye.
Scene lit_square(const MappedMaterial& material) {
  Scene scene;
  add(scene, Square{}, scaled(4), material);
  scene.lights = {directional({-0.6, 0, -0.8})};
  return scene;
}

// A cube of glass of edge `thickness` over a square, lit along the way that the eye looks from.
Scene glass_over_floor(const MappedMaterial& glass, double thickness) {
  Scene scene;
  add(scene, Square{}, scaled(9), diffuse(Rgb(1)));
  add(scene, Box{}, moved(0, 0, 2) * scaled(thickness), glass);
  scene.lights = {directional({0, 0, -1})};
  return scene;
}

// The floor beside the eye's axis, through nothing.
const Ray past_the_glass{{3, 0, 0.5}, glm::normalize(Vec3(-3, 0, -0.5))};

}  // namespace

TEST_CASE("Blinn and Phong's highlight is the power of the cosine between normal and half vector") {
  MappedMaterial material = with_extras(specular(Rgb(1), 5));
  // The half vector of (0.6, 0, 0.8) and (0, 0, 1) is (0.6, 0, 1.8) / 1.897; the mirrored direction's cosine
  // is 0.8.
  CHECK(seen(lit_square(material)) == near(Rgb(std::pow(0.8, 5))));
  material.blinn_phong = true;
  CHECK(seen(lit_square(material)) == near(Rgb(std::pow(1.8 / std::sqrt(0.36 + 3.24), 5))));
}

TEST_CASE("Blinn and Phong's highlight is not on the side away from the light") {
  MappedMaterial material = with_extras(specular(Rgb(1), 1) + diffuse(Rgb(0.5)));
  material.blinn_phong = true;
  Scene scene = lit_square(material);
  scene.lights = {directional({-0.99, 0, 0.14})};
  CHECK(seen(scene) == Rgb(0));
}

TEST_CASE("glass dims by Beer's coefficients on top of its transmission, in sight and in shadow") {
  MappedMaterial glass = with_extras(transmissive(Rgb(0.5, 1, 1)));
  glass.absorb = Rgb(0, 2, 0.25);
  const Scene scene = glass_over_floor(glass, 0.5);
  const Rgb through(std::sqrt(0.5), std::exp(-1.0), std::exp(-0.125));
  CHECK(seen(scene, past_the_glass) == near(through));             // the shadow
  CHECK(seen(scene, from_front(), 3) == near(through * through));  // seen through the glass
}

TEST_CASE("transmissive shadows are by distance, once a surface, or none") {
  const Scene scene = glass_over_floor(with_extras(transmissive(Rgb(0.25, 1, 0.5))), 0.5);
  ShadingOptions options;
  CHECK(seen(scene, past_the_glass, 0, options) == near(0.5, 1, std::sqrt(0.5)));
  options.transmissive_shadows = TransmissiveShadows::surface;
  CHECK(seen(scene, past_the_glass, 0, options) == near(0.25, 1, 0.5));
  options.transmissive_shadows = TransmissiveShadows::none;
  CHECK(seen(scene, past_the_glass, 0, options) == Rgb(1));
}

TEST_CASE("without transmissive shadows opaque objects cast theirs") {
  Scene scene = glass_over_floor(with_extras(transmissive(Rgb(0.25))), 0.5);
  add(scene, Sphere{}, moved(0, 0, 4), diffuse(Rgb(1)));
  ShadingOptions options;
  options.transmissive_shadows = TransmissiveShadows::none;
  CHECK(seen(scene, past_the_glass, 0, options) == Rgb(0));
}

TEST_CASE("fog is between the eye and what it sees, and not in mirrors") {
  Scene scene;
  add(scene, Square{}, scaled(4), reflective(Rgb(1)));
  surround(scene, {255, 0, 0});
  Fog fog;
  fog.color = Rgb(0, 0, 1);
  fog.end = 20;
  scene.fog = fog;
  CHECK(seen(scene, 1) == near(0.75, 0, 0.25));  // the mirror is at distance 5
  CHECK(seen(scene, Ray{{0, 0, 5}, {0, 0, 1}}) == Rgb(0, 0, 1));
}

TEST_CASE("a glossy mirror shows the average of what is around the mirrored direction") {
  MappedMaterial mirror = with_extras(reflective(Rgb(1)));
  Scene scene;
  add(scene, Square{}, scaled(4), mirror);
  add(scene, Square{}, moved(2, 0, 9) * turned(3.14159265358979, 0, 1, 0) * scaled(4),
      emissive(Rgb(1)));  // x > 0
  ShadingOptions options;
  options.light_samples = 8;
  const Ray ray = from_front();
  const Rgb sharp = seen(scene, ray, 1, options);
  scene.materials[0].glossiness = 0.2;
  const Traced glossy = traced(scene, ray, 1, options);
  CHECK((sharp == Rgb(0) || sharp == Rgb(1)));
  CHECK(glossy.rays.reflected == 64);
  CHECK(glossy.color.x == Approx(0.5).margin(0.1));
  options.light_samples = 1;
  CHECK(seen(scene, ray, 1, options) == sharp);
}

TEST_CASE("a light with a size casts a soft shadow whose middle is half as bright") {
  Scene scene;
  add(scene, Square{}, scaled(99), diffuse(Rgb(1)));
  // A screen at z = 2 over x < 0; the light at z = 4 is over -1 < x < 1: so is the penumbra.
  add(scene, Square{}, moved(-10, 0, 2) * scaled(20), diffuse(Rgb(0)));
  AreaLight light{};
  light.color = Rgb(1);
  light.position = Vec3(-1, -1e-6, 4);
  light.u = Vec3(2, 0, 0);
  light.v = Vec3(0, 2e-6, 0);
  ShadingOptions options;
  options.light_samples = 16;
  const auto floor_at = [&](double x, bool shadows) {
    options.shadows = shadows;
    scene.lights = {light};
    return seen(scene, Ray{{x, 0, 0.5}, {0, 0, -1}}, 0, options).x;
  };
  CHECK(floor_at(-1.1, true) == 0);
  CHECK(floor_at(1.1, true) == floor_at(1.1, false));
  // At x the screen's edge hides the light's part below -x.
  for (const double x : {-0.5, 0.0, 0.5}) {
    CHECK(floor_at(x, true) / floor_at(x, false) == Approx((1 + x) / 2).margin(0.02));
  }
}

TEST_CASE("each sample of a light counts as a shadow ray, cast or spared") {
  Scene scene;
  add(scene, Square{}, scaled(4), diffuse(Rgb(1)));
  AreaLight light{};
  light.color = Rgb(1);
  light.position = Vec3(0, 0, 9);
  light.u = Vec3(1, 0, 0);
  light.v = Vec3(0, 1, 0);
  AreaLight black = light;
  black.color = Rgb(0);
  scene.lights = {light, black};
  ShadingOptions options;
  options.light_samples = 3;
  options.count_work = true;
  const Traced result = traced(scene, from_front(), 0, options);
  CHECK(result.rays.shadow == 9);
  CHECK(result.rays.work.shadows.culled == 9);
}

TEST_CASE("no shadow ray is cast for a point outside of a beam") {
  Scene scene;
  add(scene, Square{}, scaled(4), diffuse(Rgb(1)));
  SpotLight light{};
  light.color = Rgb(1);
  light.position = Vec3(0, 0, 3);
  light.beam.direction = Vec3(0, 0, -1);
  light.beam.cosine_of_edge = light.beam.cosine_of_full = 0.9;
  scene.lights = {light};
  ShadingOptions options;
  options.count_work = true;
  CHECK(traced(scene, from_front(), 0, options).rays.shadow == 1);
  const Traced outside = traced(scene, Ray{{1.8, 0, 5}, {0, 0, -1}}, 0, options);
  CHECK(outside.rays.shadow == 0);
  CHECK(outside.rays.work.shadows.out_of_reach == 1);
  CHECK(outside.color == Rgb(0));
}
