#include "shading/local_shading.hpp"

#include <algorithm>

#include "shading/shadow.hpp"

namespace trace {
namespace {

// The direction of a light's reflection at the surface.
Vec3 highlight_direction(const Vec3& normal, const Vec3& towards_light, bool from_behind) {
  const double cosine = glm::dot(normal, towards_light);
  if (from_behind && cosine < 0) return glm::normalize(2 * -cosine * normal - towards_light);
  return 2 * std::max(0.0, cosine) * normal - towards_light;
}

// What is raised to the power of the shininess. Blinn, "Models of Light Reflection for Computer Synthesized
// Pictures", SIGGRAPH 1977: the cosine between the normal and the vector halfway from the light to the
// viewer, of a surface that is lit from the side of its normal. The shininess is taken as it is given.
double highlight_cosine(const DialectRules& rules, const Surface& surface, const Vec3& normal,
                        const Vec3& towards_light, const Vec3& to_viewer, bool from_behind) {
  if (!surface.given().blinn_phong && !rules.halfway_highlights) {
    return std::max(0.0, glm::dot(highlight_direction(normal, towards_light, from_behind), to_viewer));
  }
  Vec3 side = normal;
  if (!(glm::dot(normal, towards_light) > 0)) {
    if (!from_behind) return 0;
    side = -normal;
  }
  const Vec3 half = towards_light + to_viewer;
  return is_zero(half) ? 0 : std::max(0.0, glm::dot(side, glm::normalize(half)));
}

// The formulas, in plain numbers (Color = Rgb) or by the rules of PartialRgb, which are needed only where the
// plain result is not finite: what a surface shows of itself, what share of one light's light it sends to the
// viewer, and how much that is.
template <class Color>
Color own_light(const Material& material, const Rgb& ambient) {
  return Color(material.emissive) + Color(material.ambient) * Color(ambient);
}
template <class Color>
Color reflected_share(const Material& material, double diffuse, double specular) {
  return Color(material.diffuse) * Color(Rgb(diffuse)) + Color(material.specular) * Color(Rgb(specular));
}
template <class Color>
Color received(const Rgb& light, double attenuation, const Color& shadow, const Color& share) {
  return Color(light) * Color(Rgb(attenuation)) * shadow * share;
}

}  // namespace

PartialRgb shade_locally(const TracedScene& world, const Surface& surface, const Vec3& toward_surface,
                         RayCounts& counts) {
  const Scene& scene = world.scene();
  const ShadingOptions& options = world.options();
  const Material& material = surface.material();
  SparedShadows uncounted;
  SparedShadows& spared = options.count_work ? counts.work.shadows : uncounted;
  spared.culled += world.culled_lights();
  PartialRgb color(own_light<Rgb>(material, scene.ambient));
  if (!color.finite()) color = own_light<PartialRgb>(material, scene.ambient);
  const bool transmits = material.transmits();
  Vec3 normal = surface.normal();
  if (!all_finite(surface.point() * 0.0 + normal)) {
    spared.out_of_reach += world.lights().size();
    return color;
  }
  const bool is_back = glm::dot(normal, toward_surface) > 0;
  const DialectRules& rules = scene.rules;
  if (is_back && (transmits || rules.two_sided)) normal = -normal;
  const double shininess = luminance(material.shininess);
  // A surface that sends nothing of a light needs no shadow ray, unless 0 times what comes back is not 0.
  const bool may_skip = !scene.shadow_may_be_undefined && shininess >= 0;
  const bool unlit_back = is_back && !transmits && !rules.two_sided;
  const bool unlit = unlit_back || (may_skip && is_zero(material.diffuse) && is_zero(material.specular));
  if (unlit && !options.model_everything) {
    (unlit_back ? spared.from_back : spared.reflects_nothing) += world.lights().size();
    return color;
  }

  const Vec3 to_viewer = -toward_surface;
  for (const PlainLight& light : world.lights()) {
    const LightSample sample = std::visit([&](const auto& l) { return l.sample(surface.point()); }, light);
    const Rgb& light_color = std::visit([](const auto& l) -> const Rgb& { return l.color; }, light);
    if (!sample.reaches) {
      ++spared.out_of_reach;
      continue;
    }
    const double cosine = glm::dot(normal, sample.towards);
    const double diffuse = transmits && !rules.two_sided ? std::abs(cosine) : std::max(0.0, cosine);
    double specular = 0;
    const bool may_shine = !rules.halfway_highlights || cosine > 0;
    if (may_shine && (options.model_everything || needs_highlight(material, shininess))) {
      specular = std::pow(highlight_cosine(rules, surface, normal, sample.towards, to_viewer,
                                           options.backface_specular && transmits),
                          shininess);
      if (options.count_work) ++counts.work.highlights;
    }
    const Rgb share = reflected_share<Rgb>(material, diffuse, specular);
    const bool adds = !unlit && !(may_skip && is_zero(share));
    if (!adds && !options.model_everything) {
      ++spared.behind;
      continue;
    }
    const PartialRgb shadow = shadow_attenuation(scene, world.tree(), options,
                                                 surface.leaving(sample.towards), sample.distance, counts);
    if (!adds) continue;  // thrown away
    const PartialRgb sum(color.value + received<Rgb>(light_color, sample.attenuation, shadow.value, share),
                         color.undefined | shadow.undefined);
    if (sum.finite()) {
      color = sum;
    } else {
      color += received<PartialRgb>(light_color, sample.attenuation, shadow,
                                    reflected_share<PartialRgb>(material, diffuse, specular));
    }
  }
  return color;
}

}  // namespace trace
