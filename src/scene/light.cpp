#include "scene/light.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "scene/sample_pattern.hpp"

namespace trace {
namespace {

Vec3 place_on(const AreaLight& light, const Vec2& s, double third) {
  switch (light.extent) {
    case AreaLight::Extent::parallelogram:
      return light.position + s.x * light.u + s.y * light.v;
    case AreaLight::Extent::disc: {
      const Vec2 d = on_disc(s);
      return light.position + d.x * light.u + d.y * light.v;
    }
    case AreaLight::Extent::ball:
      break;
  }
  return light.position + glm::length(light.u) * radius_of_even_disc(third) * on_sphere(s);
}

Vec3 middle_of(const AreaLight& light) {
  if (light.extent != AreaLight::Extent::parallelogram) return light.position;
  return light.position + 0.5 * light.u + 0.5 * light.v;
}

}  // namespace

LightSample SpotLight::sample(const Vec3& point) const {
  LightSample result = PointLight{color, position, constant, linear, quadratic}.sample(point);
  if (!result.reaches) return result;
  const double share = beam.share(position, point, result.towards, result.distance);
  if (!(share > 0)) return {result.towards, result.distance, 0, false};
  result.attenuation *= share;
  return result;
}

std::vector<PlainLight> AreaLight::samples(int n) const {
  std::vector<PlainLight> result;
  const int count = n * n;
  const Rgb part = color / static_cast<double>(count);
  for (int k = 0; k < count; ++k) {
    const Vec3 place =
        n == 1 ? middle_of(*this)
               : place_on(*this, multi_jittered(n, k), radical_inverse(static_cast<std::uint32_t>(k)));
    if (beam.limits_anything()) {
      result.emplace_back(SpotLight{part, place, constant, linear, quadratic, beam});
    } else {
      result.emplace_back(PointLight{part, place, constant, linear, quadratic});
    }
  }
  return result;
}

}  // namespace trace
