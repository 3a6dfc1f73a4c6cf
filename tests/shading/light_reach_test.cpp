// Lights where the arithmetic of their distance gets hard: in the surface, next to it, beyond squares.
#include "tests/support/constants.hpp"
#include "tests/support/numbers_near.hpp"
#include "tests/support/scene_trace.hpp"

using namespace trace;
using namespace trace::test;

namespace {

const Rgb surface_color(0.8, 0.6, 0.4);

Traced seen_lit(const Material& material, const Light& light) {
  Scene scene;
  add(scene, Square{}, at_origin(), material);
  scene.lights = {light};
  return traced(scene, from_front());
}

}  // namespace

TEST_CASE("a point light exactly in the surface adds nothing, whatever its coefficients and the shininess") {
  const float a = GENERATE(0.0f, 1.0f, -1.0f);
  const double shininess = GENERATE(0.0, 1.0, -1.0);
  const Traced seen = seen_lit(emissive(Rgb(0.25)) + diffuse(surface_color) + specular(Rgb(1), shininess),
                               PointLight{Rgb(1), Vec3(0), a, 0, 0});
  CHECK(seen.color == Rgb(0.25));
  CHECK_FALSE(seen.undefined.any());
}

TEST_CASE("a point light as near as numbers go is not attenuated and shines from where it is") {
  const double distance = GENERATE(1e-9, 1e-100, 1e-160, 1e-200, 5e-324);
  const LightSample sample = PointLight{Rgb(1), Vec3(0, distance, 0)}.sample(Vec3(0));
  REQUIRE(sample.reaches);
  CHECK(sample.towards == near(0, 1, 0, 3e-16));
  CHECK(sample.distance == Approx(distance).epsilon(1e-15));
  CHECK(sample.attenuation == 1);
  CHECK(seen_lit(diffuse(surface_color), PointLight{Rgb(1), Vec3(0, 0, distance)}).color ==
        near(surface_color));
}

TEST_CASE("a point light as far as numbers go shines from its direction, with what its coefficients leave") {
  const double distance = GENERATE(1e100, 1e160, 1e300);
  const Vec3 position(0.6 * distance, 0, 0.8 * distance);
  const LightSample square = PointLight{Rgb(1), position}.sample(Vec3(0));
  REQUIRE(square.reaches);
  CHECK(square.towards == near(0.6, 0, 0.8, 1e-15));
  CHECK(square.distance == Approx(distance).epsilon(1e-15));
  CHECK(square.attenuation >= 0);
  CHECK(square.attenuation <= 1.001e-200);
  // Linear: 1 / (1e-3 s), as a float. Constant: all of it. More than all is all.
  const double linear = static_cast<double>(1e-3f);
  CHECK(PointLight{Rgb(1), position, 0, 1e-3f, 0}.sample(Vec3(0)).attenuation ==
        Approx(1 / (linear * distance)).epsilon(1e-14));
  CHECK(PointLight{Rgb(1), position, 1, 0, 0}.sample(Vec3(0)).attenuation == 1);
  CHECK(PointLight{Rgb(1), position, 0, -1, 0}.sample(Vec3(0)).attenuation == 1);
  CHECK(PointLight{Rgb(1), position, 0, -1, 1}.sample(Vec3(0)).attenuation <= 1.001e-200);
  CHECK(PointLight{Rgb(1), position, 0, 1, -1}.sample(Vec3(0)).attenuation == 1);
}

TEST_CASE("a point light does not reach where no number says how far it is") {
  const PointLight light{Rgb(1), Vec3(1.7e308, 0, 0)};
  CHECK_FALSE(light.sample(Vec3(-1.7e308, 0, 0)).reaches);
  CHECK_FALSE(light.sample(Vec3(infinity, 0, 0)).reaches);
  CHECK_FALSE((PointLight{Rgb(1), Vec3(1.7e308)}).sample(Vec3(0)).reaches);  // length 2.9e308
}

TEST_CASE("a directional light without a direction reaches nothing") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE((DirectionalLight{Rgb(1), Vec3(nan)}).sample(Vec3(0)).reaches);
  CHECK_FALSE((DirectionalLight{Rgb(1), Vec3(0)}).sample(Vec3(0)).reaches);
  CHECK_FALSE((DirectionalLight{Rgb(1), Vec3(infinity, nan, nan)}).sample(Vec3(0)).reaches);
  CHECK((DirectionalLight{Rgb(1), Vec3(0, 0, 1)}).sample(Vec3(0)).reaches);
  // Not even the highlight of shininess 0, which is there for every direction.
  CHECK(seen_lit(specular(surface_color, 0), DirectionalLight{Rgb(1), Vec3(0)}).color == Rgb(0));
}
