#include "scene/light.hpp"

#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

TEST_CASE("a point light is attenuated by 1 / (a + b s + c s^2), and never made brighter") {
  struct Case {
    float a, b, c;
    double s, attenuation;
  };
  const Case c = GENERATE(Case{0, 0, 1, 2, 0.25},        // the default: 1 / s^2
                          Case{0, 0, 1, 0.5, 1},         // f = 1/4
                          Case{0, 0, 1, 1, 1},           //
                          Case{0.5f, 0, 1, 2, 1 / 4.5},  //
                          Case{0.5f, 1, 0, 2, 0.4},      // f = 2.5
                          Case{1, 2, 3, 2, 1 / 17.0},    // f = 1 + 4 + 12
                          Case{0, 0, 0, 2, 1},           //
                          Case{-0.5f, 0, 0, 2, 1},       //
                          Case{0, 0, -1, 2, 1});
  const PointLight light{Rgb(1), Vec3(0, 0, c.s), c.a, c.b, c.c};
  const LightSample sample = light.sample(Vec3(0));
  CHECK(sample.attenuation == about(c.attenuation));
  CHECK(sample.distance == about(c.s));
  CHECK(sample.towards == near(0, 0, 1));
}

TEST_CASE("without coefficients a point light falls off with the square of the distance") {
  const PointLight light{Rgb(1), Vec3(3, 4, 0)};
  const LightSample sample = light.sample(Vec3(0));
  CHECK(sample.distance == about(5));
  CHECK(sample.attenuation == about(1.0 / 25));
  CHECK(sample.towards == near(0.6, 0.8, 0));
}

TEST_CASE("the coefficients of a point light have 32 bits") {
  // 0.1f is 0.100000001490116; ten times that over 1, and the double 0.1 would give 0.1 + 1.
  const PointLight light{Rgb(1), Vec3(0, 0, 1), 1, 0.1f, 0};
  CHECK(light.sample(Vec3(0)).attenuation == 1 / (1 + 0.100000001490116119384765625));
}

TEST_CASE("a directional light is the same everywhere and infinitely far") {
  const DirectionalLight light{Rgb(1), Vec3(0, 0.6, 0.8)};
  const LightSample sample = light.sample(Vec3(100, -1e6, 3));
  CHECK(sample.towards == Vec3(0, 0.6, 0.8));
  CHECK(sample.attenuation == 1);
  CHECK(sample.distance == std::numeric_limits<double>::infinity());
}
