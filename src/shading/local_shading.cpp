#include "shading/local_shading.hpp"

#include <algorithm>

namespace trace {
namespace {

// The direction of a light's reflection at the surface.
Vec3 highlight_direction(const Vec3& normal, const Vec3& towards_light, bool from_behind) {
  const double cosine = glm::dot(normal, towards_light);
  if (from_behind && cosine < 0) return glm::normalize(2 * -cosine * normal - towards_light);
  return 2 * std::max(0.0, cosine) * normal - towards_light;
}

}  // namespace

Rgb shade_locally(const Scene& scene, const SceneTree& tree, const ShadingOptions& options,
                  const Surface& surface, const Vec3& toward_surface, RayCounts& counts) {
  const Material& material = surface.material();
  Rgb color = material.emissive + material.ambient * scene.ambient;
  const bool transmits = material.transmits();
  Vec3 normal = surface.normal();
  if (!is_finite(normal)) return color;
  if (glm::dot(normal, toward_surface) > 0) {
    if (!transmits) return color;
    normal = -normal;
  }
  const double shininess = luminance(material.shininess);
  // A surface that sends nothing of a light needs no shadow ray, unless 0 times what comes back is not 0.
  const bool may_skip = !scene.shadow_may_be_undefined && shininess >= 0;
  if (may_skip && is_zero(material.diffuse) && is_zero(material.specular)) return color;

  const Vec3 to_viewer = -toward_surface;
  for (const Light& light : scene.lights) {
    const LightSample sample = std::visit([&](const auto& l) { return l.sample(surface.point()); }, light);
    const Rgb& light_color = std::visit([](const auto& l) -> const Rgb& { return l.color; }, light);
    if (!is_finite(sample.towards)) continue;
    const double cosine = glm::dot(normal, sample.towards);
    const double diffuse = transmits ? std::abs(cosine) : std::max(0.0, cosine);
    const Vec3 highlight =
        highlight_direction(normal, sample.towards, options.backface_specular && transmits);
    const double specular = std::pow(std::max(0.0, glm::dot(highlight, to_viewer)), shininess);
    const Rgb reflected = material.diffuse * diffuse + material.specular * specular;
    if (may_skip && is_zero(reflected)) continue;
    const Rgb shadow =
        shadow_attenuation(scene, tree, options, surface.leaving(sample.towards), sample.distance, counts);
    color += light_color * sample.attenuation * shadow * reflected;
  }
  return color;
}

}  // namespace trace
