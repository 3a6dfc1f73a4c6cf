#include "scene/dialect_lights.hpp"

#include <catch2/catch.hpp>

#include "tests/support/light_describe.hpp"
#include "tests/support/numbers_near.hpp"

using namespace trace;
using namespace trace::test;

namespace {

using LightKind = parser::DialectLight::Kind;

struct MadeLight {
  std::optional<Light> light;
  parser::Diagnostics diagnostics;
};

MadeLight made(LightKind kind, std::string_view word, std::initializer_list<Said> attributes) {
  MadeLight result;
  result.light = make_light(dialect_light(kind, word, attributes), result.diagnostics);
  return result;
}

// Without complaints.
SpotLight plain_spot(LightKind kind, std::initializer_list<Said> attributes) {
  const MadeLight result = made(kind, "spot_light", attributes);
  for (const auto& d : result.diagnostics.all()) INFO(d.text);
  CHECK(result.diagnostics.all().empty());
  REQUIRE(result.light);
  return std::get<SpotLight>(*result.light);
}
SpotLight spot_of(std::initializer_list<Said> attributes) {
  return plain_spot(LightKind::spot, attributes);
}

// What is left of the light at points all around, against another light.
void check_same_light(const SpotLight& a, const SpotLight& b) {
  CHECK(a.color == b.color);
  int lit = 0;
  for (int x = -8; x <= 8; ++x) {
    for (int y = -8; y <= 8; ++y) {
      const Vec3 point(0.27 * x, 0.31 * y, -4 + 0.1 * x);
      const LightSample s = a.sample(point), t = b.sample(point);
      CHECK(s.reaches == t.reaches);
      CHECK(s.attenuation == Approx(t.attenuation).margin(1e-12));
      lit += s.reaches;
    }
  }
  CHECK(lit > 0);
}

std::string only_text(const MadeLight& result) {
  REQUIRE(result.diagnostics.all().size() == 1);
  return result.diagnostics.all()[0].text;
}

double share_at_angle(const SpotLight& light, double degrees) {
  const double a = degrees * 3.14159265358979323846 / 180;
  const LightSample s = light.sample(light.position + 2.0 * Vec3(std::sin(a), 0, -std::cos(a)));
  return s.reaches ? s.attenuation : 0;
}

}  // namespace

TEST_CASE("a spot light shines inside its cone, whose angle is that of its half in degrees") {
  const SpotLight light =
      spot_of({{"position", 1, 2, 3}, {"color", 1, 0.5, 0}, {"direction", 0, 0, -5}, {"angle", 20}});
  CHECK(light.color == Rgb(1, 0.5, 0));
  CHECK(share_at_angle(light, 0) == 1);
  CHECK(share_at_angle(light, 19.9) == 1);
  CHECK(share_at_angle(light, 20.1) == 0);
  CHECK(share_at_angle(light, 180) == 0);
}

TEST_CASE("between its two angles a spot light falls off by the smooth step of the cosine") {
  const SpotLight light = spot_of(
      {{"position", 0, 0, 0}, {"color", 1, 1, 1}, {"target", 0, 0, -9}, {"angle", 60}, {"inner_angle", 30}});
  CHECK(share_at_angle(light, 29.9) == 1);
  const double cosine = std::cos(45 * 3.14159265358979323846 / 180), inner = std::sqrt(3.0) / 2,
               t = (cosine - 0.5) / (inner - 0.5);
  CHECK(share_at_angle(light, 45) == Approx(3 * t * t - 2 * t * t * t));
  CHECK(share_at_angle(light, 60.1) == 0);
}

TEST_CASE("a spot light falls off with a power of the cosine, with its coefficients and towards its end") {
  const SpotLight light = spot_of({{"position", 0, 0, 0},
                                   {"color", 1, 1, 1},
                                   {"direction", 0, 0, -1},
                                   {"angle", 80},
                                   {"exponent", 3},
                                   {"constant_attenuation_coeff", 0.5},
                                   {"linear_attenuation_coeff", 0.25},
                                   {"quadratic_attenuation_coeff", 0.125},
                                   {"cutoff_distance", 8}});
  // At distance 2: 1 / (0.5 + 0.5 + 0.5), and (1 - 2 / 8)^2.
  CHECK(share_at_angle(light, 60) == Approx(0.125 / 1.5 * 0.5625));
  CHECK_FALSE(light.sample(Vec3(0, 0, -8)).reaches);
}

TEST_CASE("without coefficients a light of a dialect does not fade") {
  const SpotLight light =
      spot_of({{"position", 0, 0, 0}, {"color", 1, 1, 1}, {"direction", 0, 0, -1}, {"angle", 20}});
  CHECK(light.sample(Vec3(0, 0, -1000)).attenuation == 1);
}

TEST_CASE("the dialects' ways to say a spot light are our own") {
  const Said position("position", 0, 0, 0), color("color", 1, 1, 1), direction("direction", 0, 0, -1);
  const SpotLight hard = spot_of({position, color, direction, {"angle", 30}});
  check_same_light(spot_of({position, color, direction, {"edgeplace", 30, 0, 0}}), hard);
  check_same_light(spot_of({position, color, direction, {"cut_off_angle", 30}}), hard);
  check_same_light(spot_of({position, color, {"central_direction", 0, 0, -3}, {"angle", 30}}), hard);
  check_same_light(spot_of({position, {"colour", 1, 1, 1}, {"target", 0, 0, -3}, {"atten_angle", 30}}), hard);
  check_same_light(spot_of({position, color, direction, {"size", 60}}), hard);
  check_same_light(
      spot_of({position, color, {"conedirection", 0, 0, -2}, {"coneboundary", 0.5, 0, -std::sqrt(0.75)}}),
      hard);
  const SpotLight soft = spot_of({position, color, direction, {"angle", 30}, {"inner_angle", 10}});
  check_same_light(spot_of({position, color, direction, {"cone_angle", 30}, {"penumbra", 10}}), soft);
  check_same_light(spot_of({position, color, direction, {"coneAngle", 30}, {"coneDeltaAngle", 20}}), soft);
  const SpotLight power = spot_of({position, color, direction, {"angle", 30}, {"exponent", 6}});
  check_same_light(spot_of({position, color, direction, {"coneangle", 30}, {"focus_constraint", 6}}), power);
  check_same_light(spot_of({position, color, direction, {"angle", 30}, {"beamDistribution", 6}}), power);
  check_same_light(spot_of({position, color, direction, {"angle", 30}, {"drop_off_rate", 6}}), power);
  check_same_light(spot_of({position, color, direction, {"angle", 30}, {"fall_rate", 6}}), power);
  const SpotLight twice = spot_of({position, {"color", 2, 2, 2}, direction, {"angle", 30}});
  check_same_light(spot_of({position, color, direction, {"angle", 30}, {"intensity_factor", 2}}), twice);
}

TEST_CASE("a blend is the part of the cone's cap in which the light falls off") {
  const SpotLight light = spot_of(
      {{"position", 0, 0, 0}, {"color", 1, 1, 1}, {"direction", 0, 0, -1}, {"size", 120}, {"blend", 0.5}});
  // From the cosine 0.5 to 0.75.
  CHECK(share_at_angle(light, 41.4) == 1);
  CHECK(share_at_angle(light, 51.317812546510554) == Approx(0.5));
}

TEST_CASE("an angle that is given in radians is warned of") {
  const MadeLight result =
      made(LightKind::spot, "spot_light",
           {{"position", 0, 0, 0}, {"color", 1, 1, 1}, {"direction", 0, 0, -1}, {"angle", 0.5}});
  CHECK(result.light);
  CHECK(only_text(result) ==
        "'angle' is in degrees: 0.5 is a very narrow beam; 0.5 radians would be 28.6479");
  CHECK(result.diagnostics.all()[0].severity == parser::Severity::warning);
}

TEST_CASE("what a light of a dialect lacks, says twice or cannot take is an error at its place") {
  const Said position("position", 0, 0, 0), color("color", 1, 1, 1), direction("direction", 0, 0, -1);
  const auto spot = [](std::initializer_list<Said> attributes) {
    return made(LightKind::spot, "spot_light", attributes);
  };
  CHECK(only_text(spot({color, direction, {"angle", 30}})) == "spot_light has no 'position'");
  CHECK(only_text(spot({position, direction, {"angle", 30}})) == "spot_light has no 'color'");
  CHECK(only_text(spot({position, color, {"angle", 30}})) == "spot_light has no 'direction' or 'target'");
  CHECK(only_text(spot({position, color, direction})) == "spot_light has no 'angle'");
  const MadeLight twice = spot({position, color, direction, {"angle", 30}, {"edgeplace", 30, 0, 0}});
  CHECK(only_text(twice) == "'edgeplace' says again what 'angle' says");
  CHECK(twice.diagnostics.all()[0].span.begin == 50);
  REQUIRE(twice.diagnostics.all()[0].notes.size() == 1);
  CHECK(twice.diagnostics.all()[0].notes[0].span.begin == 40);
  const MadeLight type = spot({{"position", 3}, color, direction, {"angle", 30}});
  CHECK(only_text(type) == "'position' takes three numbers");
  CHECK(type.diagnostics.all()[0].span.begin == 16);
  CHECK_FALSE(type.light);
  CHECK(only_text(spot({position, color, direction, {"angle", 30}, {"exponent", 1, 2, 3}})) ==
        "'exponent' takes one number");
  CHECK(only_text(spot({position, color, {"direction", 0, 0, 0}, {"angle", 30}})) ==
        "'direction' must be longer than 0");
  CHECK(only_text(spot({position, color, direction, {"target", 1, 0, 0}, {"angle", 30}})) ==
        "'target' stands beside 'direction'");
  CHECK(only_text(spot({position, color, {"target", 0, 0, 0}, {"angle", 30}})) ==
        "'target' is the position of the light");
  CHECK(only_text(spot({position, color, direction, {"angle", 190}})) ==
        "'angle' must be greater than 0 and at most 180 degrees");
  CHECK(only_text(spot({position, color, direction, {"angle", 30}, {"inner_angle", 31}})) ==
        "'inner_angle' must not exceed 'angle'");
  CHECK(only_text(spot({position, color, direction, {"angle", 30}, {"exponent", -1}})) ==
        "'exponent' must not be negative");
}

TEST_CASE("attributes that mean nothing beside the others are warned of") {
  const MadeLight result =
      made(LightKind::warn, "warn_light",
           {{"position", 0, 0, 0}, {"color", 1, 1, 1}, {"direction", 0, 0, -1}, {"type", 2}});
  CHECK(result.light);
  CHECK(only_text(result) == "'type' has no effect in this warn_light");
}

TEST_CASE("Warn's light has a power and flaps in the world, in any of their spellings") {
  const Said position("position", 0, 0, 0), color("color", 1, 1, 1), direction("direction", 0, 0, -1);
  const SpotLight own =
      plain_spot(LightKind::warn,
                 {position, color, direction, {"exponent", 2}, {"xmin", -1}, {"xmax", 0.5}, {"zmin", -4}});
  CHECK(own.sample(Vec3(0, 0, -2)).attenuation == 1);
  CHECK(own.sample(Vec3(0, 2, -2)).attenuation == Approx(0.5));
  CHECK(own.sample(Vec3(0.5, 0, -2)).reaches);
  CHECK_FALSE(own.sample(Vec3(0.51, 0, -2)).reaches);
  CHECK_FALSE(own.sample(Vec3(-1.01, 0, -2)).reaches);
  CHECK_FALSE(own.sample(Vec3(0, 0, -4.1)).reaches);
  CHECK_FALSE(own.sample(Vec3(0, 0, 2)).reaches);
  check_same_light(
      plain_spot(
          LightKind::warn,
          {position, color, {"normal", 0, 0, -1}, {"p", 2}, {"x_min", -1}, {"x_max", 0.5}, {"z_min", -4}}),
      own);
  check_same_light(plain_spot(LightKind::warn_model, {position,
                                                      color,
                                                      {"central_direction", 0, 0, -1},
                                                      {"specular_exponent", 2},
                                                      {"xflapmin", -1},
                                                      {"xflapmax", 0.5},
                                                      {"zflapmin", -4}}),
                   own);
}

TEST_CASE("flaps around the light need no direction") {
  const SpotLight light =
      plain_spot(LightKind::warn,
                 {{"position", 3, -3, 6}, {"color", 1, 1, 1}, {"xflap", 4}, {"yflap", 6}, {"zflap", 8}});
  CHECK(light.sample(Vec3(7, 3, -2)).reaches);
  CHECK_FALSE(light.sample(Vec3(7.1, 3, -2)).reaches);
  CHECK_FALSE(light.sample(Vec3(7, 3, -2.1)).reaches);
  CHECK(light.sample(Vec3(3, -3, 7)).reaches);
}

TEST_CASE("between two corner flaps Warn's light has the eighth power, and the outline that its shape says") {
  const auto shaped = [](double shape) {
    return plain_spot(LightKind::warn, {{"shape", shape},
                                        {"position", 0, 2, 0},
                                        {"color", 1, 1, 1},
                                        {"direction", 0, -2, 0},
                                        {"edgeplace", 90, 0, 0},
                                        {"flap_0", -2, -1, -2},
                                        {"flap_1", 1, 1, 1}});
  };
  const SpotLight box = shaped(0), half = shaped(1), circle = shaped(2);
  CHECK(box.sample(Vec3(0, -1, 1)).attenuation == Approx(std::pow(0.9, 4)));  // the cosine is 3 / sqrt(10)
  CHECK_FALSE(box.sample(Vec3(0, -1.01, 1)).reaches);
  CHECK_FALSE(box.sample(Vec3(1.2, -1, 0)).reaches);
  CHECK(half.sample(Vec3(-1, -1, -0.1)).reaches);
  CHECK_FALSE(half.sample(Vec3(-1, -1, 0.1)).reaches);
  CHECK(circle.sample(Vec3(1.6, -1, -0.5)).reaches);  // 2.1213 from the middle at x = -0.5
  CHECK_FALSE(circle.sample(Vec3(1.63, -1, -0.5)).reaches);
}

TEST_CASE("a beam along z has the outline of a regular polygon, turned by its direction") {
  const SpotLight light = plain_spot(LightKind::warn, {{"position", 1, 1, 1},
                                                       {"color", 1, 1, 1},
                                                       {"type", 1, 0, 0},
                                                       {"radius", 2, 0, 0},
                                                       {"direction", 90, 0, 0}});
  // The corner is at x = 3, the opposite edge at x = 0.
  CHECK(light.sample(Vec3(2.99, 1, 50)).reaches);
  CHECK(light.sample(Vec3(2.99, 1, -50)).reaches);
  CHECK_FALSE(light.sample(Vec3(3.01, 1, -50)).reaches);
  CHECK(light.sample(Vec3(0.01, 1, -50)).reaches);
  CHECK_FALSE(light.sample(Vec3(-0.01, 1, -50)).reaches);
}

TEST_CASE("a shape light shines through a hole in front of it, with a power of the cosine") {
  const auto shaped = [](double shape) {
    return plain_spot(LightKind::shape, {{"position", 0, 0, 0},
                                         {"color", 1, 1, 1},
                                         {"direction", 0, 0, -3},
                                         {"parms", 0.5, 2, 4},
                                         {"up", 0, 1, 0},
                                         {"shape", shape, 0, 0}});
  };
  // At z = -4 the hole's shadow is twice its size: the triangle's top at 1, its bottom at -0.5.
  const SpotLight triangle = shaped(0), square = shaped(1), star = shaped(2);
  CHECK(triangle.sample(Vec3(0, 0.99, -4)).reaches);
  CHECK_FALSE(triangle.sample(Vec3(0, 1.01, -4)).reaches);
  CHECK_FALSE(triangle.sample(Vec3(0, -0.51, -4)).reaches);
  CHECK_FALSE(triangle.sample(Vec3(0.7, 0.4, -4)).reaches);
  CHECK(square.sample(Vec3(0.99, -0.99, -4)).attenuation == Approx(std::pow(16 / (16 + 2 * 0.9801), 2)));
  CHECK_FALSE(square.sample(Vec3(1.01, 0, -4)).reaches);
  CHECK(star.sample(Vec3(0, -0.99, -4)).reaches);
  CHECK_FALSE(star.sample(Vec3(0.7, 0, -4)).reaches);
  CHECK_FALSE(star.sample(Vec3(0, 0, 4)).reaches);
}

TEST_CASE("a size beside Warn's direction is a hole at distance one") {
  const SpotLight light = plain_spot(
      LightKind::warn,
      {{"position", 0, 0, 0}, {"color", 1, 1, 1}, {"direction", 0, 0, -1}, {"type", 3}, {"size", 0.5}});
  CHECK(light.sample(Vec3(0.99, 0, -2)).reaches);
  CHECK_FALSE(light.sample(Vec3(0.71, 0.72, -2)).reaches);
}

TEST_CASE("the lights with a size are where their attributes say") {
  const Said position("position", 1, 2, 3), color("color", 8, 8, 8);
  const auto area = [](LightKind kind, std::initializer_list<Said> attributes) {
    const MadeLight result = made(kind, "area_light", attributes);
    CHECK(result.diagnostics.all().empty());
    REQUIRE(result.light);
    return std::get<AreaLight>(*result.light);
  };
  const AreaLight corner = area(LightKind::area, {position, color, {"u", -1, 0, 0}, {"v", 0, 1, 0}});
  CHECK(corner.position == Vec3(1, 2, 3));
  CHECK(corner.u == Vec3(-1, 0, 0));
  const AreaLight square = area(LightKind::area, {position, color, {"area", 0.5}});
  CHECK(square.position == Vec3(0.75, 2, 2.75));
  CHECK(square.u == Vec3(0.5, 0, 0));
  CHECK(square.v == Vec3(0, 0, 0.5));
  const AreaLight ball = area(LightKind::area, {position, color, {"light_radius", 0.5}});
  CHECK(ball.extent == AreaLight::Extent::ball);
  const AreaLight rectangle =
      area(LightKind::area_rectangle,
           {position, color, {"direction", 0, 2, 0}, {"updir", 0, 0, 1}, {"width", 4}, {"height", 2}});
  CHECK(glm::length(rectangle.u) == about(4));
  CHECK(rectangle.v == near(0, 0, 2));
  CHECK(rectangle.position + 0.5 * (rectangle.u + rectangle.v) == near(1, 2, 3));
  CHECK(rectangle.beam.share(Vec3(0), Vec3(0, 1, 0), Vec3(0, -1, 0), 1) == 1);
  CHECK(rectangle.beam.share(Vec3(0), Vec3(0, -1, 0), Vec3(0, 1, 0), 1) == 0);
  const AreaLight disc = area(LightKind::area_disc, {position, color, {"direction", 0, 0, 1}, {"radius", 2}});
  CHECK(disc.extent == AreaLight::Extent::disc);
  CHECK(only_text(made(LightKind::area, "area_light", {position, color})) ==
        "area_light has no size: 'u' and 'v', 'radius', 'bottom_radius', 'light_radius' or 'area'");
  CHECK(only_text(made(LightKind::area, "area_light", {position, color, {"u", 1, 0, 0}})) ==
        "area_light has no 'v'");
}

TEST_CASE("a spot light with a radius is a disc across its direction") {
  const MadeLight result = made(
      LightKind::spot, "spot_light",
      {{"position", 0, 0, 0}, {"color", 1, 1, 1}, {"direction", 0, 0, -1}, {"angle", 20}, {"radius", 0.5}});
  REQUIRE(result.light);
  const auto& light = std::get<AreaLight>(*result.light);
  CHECK(light.u.z == 0);
  CHECK(glm::length(light.v) == about(0.5));
  for (const PlainLight& one : light.samples(3)) CHECK(std::holds_alternative<SpotLight>(one));
}
