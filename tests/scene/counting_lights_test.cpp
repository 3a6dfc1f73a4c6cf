// Lights that change nothing in a whole scene.
#include "scene/counting_lights.hpp"

#include <catch2/catch.hpp>

#include "tests/support/scene_make.hpp"

using namespace trace;
using namespace trace::test;

namespace {

Scene ball(const Material& material) {
  Scene scene;
  add(scene, Sphere{}, at_origin(), material);
  return scene;
}

std::vector<WhyCulled> culled(const Scene& scene) {
  std::vector<WhyCulled> result;
  for (const CulledLight& light : lights_that_count(scene).culled) result.push_back(light.why);
  return result;
}

const Light white = directional({0, 0, -1});
const Light black = directional({0, 0, -1}, Rgb(0));
const Light nowhere = DirectionalLight{Rgb(1), Vec3(0)};

}  // namespace

TEST_CASE("black lights and those without a direction do not count, the others stay in order") {
  Scene scene = ball(diffuse(Rgb(0.5)));
  const Light negative = directional({0, 0, -1}, {0, -1, 0});
  scene.lights = {black, white, nowhere, negative, PointLight{Rgb(0), Vec3(1)}};
  const CountingLights lights = lights_that_count(scene);
  REQUIRE(lights.lights.size() == 2);
  CHECK(std::get<DirectionalLight>(lights.lights[0]).color == Rgb(1));
  CHECK(std::get<DirectionalLight>(lights.lights[1]).color == Rgb(0, -1, 0));
  REQUIRE(lights.culled.size() == 3);
  CHECK(lights.culled[0].light == 0);
  CHECK(lights.culled[1].light == 2);
  CHECK(lights.culled[2].light == 4);
  CHECK(culled(scene) == std::vector{WhyCulled::black, WhyCulled::no_direction, WhyCulled::black});
}

TEST_CASE("no light counts where no surface reflects any") {
  Scene scene = ball(emissive(Rgb(1)) + reflective(Rgb(1)));
  scene.lights = {white};
  CHECK(culled(scene) == std::vector{WhyCulled::nothing_reflects});
  SECTION("a diffuse colour is enough") {
    add(scene, Box{}, at_origin(), diffuse({0, 0.1, 0}));
  }
  SECTION("a specular colour is enough") {
    add(scene, Box{}, at_origin(), specular(Rgb(-1), 2));
  }
  SECTION("a map is enough") {
    MappedMaterial mapped;
    mapped.specular = 0;
    add(scene, Square{}, at_origin(), mapped);
  }
  SECTION("one point of a mesh is enough") {
    add(scene, front_triangle(), at_origin(), Material{}, {Material{}, diffuse(Rgb(1)), Material{}});
  }
  CHECK(culled(scene).empty() == (scene.objects.size() > 1));
}

TEST_CASE("no light is culled where 0 times what it meets could be undefined") {
  Scene scene = ball(diffuse(Rgb(0.5)));
  scene.lights = {black};
  REQUIRE(culled(scene).size() == 1);
  SECTION("transmission above one") {
    add(scene, Box{}, at_origin(), transmissive(Rgb(1.5)));
  }
  SECTION("negative shininess") {
    add(scene, Box{}, at_origin(), specular(Rgb(0), -1));
  }
  SECTION("shininess whose powers overflow") {
    add(scene, Box{}, at_origin(), specular(Rgb(1), 1e300));
  }
  SECTION("colours whose sums overflow") {
    add(scene, Box{}, at_origin(), diffuse(Rgb(1e308)));
  }
  SECTION("shininess of points between which rounding could make it negative") {
    add(scene, front_triangle(), at_origin(), Material{},
        {specular(Rgb(1), 0), specular(Rgb(1), 0), specular(Rgb(1), 100)});
  }
  CHECK(culled(scene).empty() == (scene.objects.size() > 1));
}

TEST_CASE("a light without a direction never counts") {
  Scene scene = ball(transmissive(Rgb(1.5)));
  scene.lights = {nowhere};
  CHECK(culled(scene) == std::vector{WhyCulled::no_direction});
}
