// Row 14: lights and views that leave a direction, a power or a quotient undefined.
#include "tests/hard/light_cases.hpp"
#include "tests/support/scene_trace.hpp"

namespace trace::hard {
namespace {

using test::operator+;

const Rgb glow(0.125, 0.25, 0.5);

// The square at z = 0 seen from (0, 0, 5), lit by one light.
Scene square_with(const Material& material, const Light& light) {
  Scene scene;
  test::add(scene, Square{}, test::scaled(4), test::emissive(glow) + material);
  scene.lights = {light};
  return scene;
}

PointLight point_light(const Vec3& position, float constant, float linear, float quadratic) {
  PointLight light{Rgb(1), position};
  light.constant = constant;
  light.linear = linear;
  light.quadratic = quadratic;
  return light;
}

// Counts what is not the expected colour, exactly.
Row expects(const char* workload, const std::vector<Rgb>& colors, const Rgb& expected) {
  Row row(ours, workload);
  Digest digest;
  for (const Rgb& color : colors) {
    ++row.rays;
    if (color != expected) ++row.wrong;
    for (int channel = 0; channel < 3; ++channel) digest.add(color[channel]);
  }
  row.digest = digest.value();
  return row;
}

// A light in the surface has no direction to it, and adds nothing; its distance is 0.
Row light_on_surface() {
  const Material material = test::diffuse(Rgb(0.5)) + test::specular(Rgb(0.25), 10);
  std::vector<Rgb> colors;
  for (const auto& [a, b, c] :
       {std::array{0.f, 0.f, 1.f}, {0.f, 0.f, 0.f}, {1.f, 0.f, 0.f}, {0.f, 1.f, 0.f}, {-1.f, 0.f, 0.f}})
    colors.push_back(test::seen(square_with(material, point_light({0, 0, 0}, a, b, c))));
  return expects("light on the surface", colors, glow);
}

// f = a + b s + c s^2 of at most 1, 0 and less among it, attenuates nothing.
Row no_attenuation() {
  std::vector<Rgb> colors;
  for (const auto& [a, b, c] :
       {std::array{0.f, 0.f, 0.f}, {1.f, 0.f, 0.f}, {-1.f, 0.f, 0.f}, {0.f, -1.f, 0.f}, {0.f, 0.f, 0.25f}})
    colors.push_back(test::seen(square_with(test::diffuse(Rgb(0.5)), point_light({0, 0, 2}, a, b, c))));
  return expects("attenuation by 0 or less", colors, glow + Rgb(0.5));
}

// x^0 is 1, of x = 0 too: with shininess 0 the highlight is flat, wherever the light stands in front.
Row shininess_zero() {
  std::vector<Rgb> colors;
  for (const Vec3& to : {Vec3(0, 0, -1), Vec3(1, 0, -1), Vec3(1, 0, -1e-9), Vec3(1, 0, 0), Vec3(0, -1, -0.5)})
    colors.push_back(test::seen(square_with(test::specular(Rgb(0.25), 0), test::directional(to))));
  return expects("shininess 0", colors, glow + Rgb(0.25));
}

Row light_without_direction() {
  const Material material = test::diffuse(Rgb(0.5)) + test::specular(Rgb(0.25), 0);
  return expects("light without direction", {test::seen(square_with(material, test::directional({0, 0, 0})))},
                 glow);
}

// A ray without direction meets nothing.
Row view_without_direction() {
  const Scene scene = square_with(test::diffuse(Rgb(0.5)), test::directional({0, 0, -1}));
  std::vector<Rgb> colors;
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const Vec3& origin : {Vec3(0, 0, 5), Vec3(0, 0, 0), Vec3(9, 9, 9)}) {
    colors.push_back(test::seen(scene, {origin, Vec3(none)}));
    colors.push_back(test::seen(scene, {origin, Vec3(0)}));
  }
  return expects("zero-length view vector", colors, Rgb(0));
}

std::vector<Row> run(std::uint64_t) {
  return {light_on_surface(), no_attenuation(), shininess_zero(), light_without_direction(),
          view_without_direction()};
}

}  // namespace

HardCase undefined_light_case() {
  return {14,
          "where a light, a view or a power is undefined the colour is that of a rule, not NaN",
          "A light in the surface has no direction, 0^0 and 1/0 appear in Phong's model and in attenuation. "
          "Each has its rule: nothing is added, the power is 1, the attenuation is 1.",
          1,
          1,
          run};
}

void add_light_cases(std::vector<HardCase>& cases) {
  cases.push_back(critical_angle_case());
  cases.push_back(terminator_case());
  cases.push_back(undefined_light_case());
}

}  // namespace trace::hard
