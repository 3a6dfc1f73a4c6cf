#include "shading/shadow.hpp"

#include "shading/transmittance.hpp"

namespace trace {

PartialRgb shadow_attenuation(const Scene& scene, const SceneTree& tree, const ShadingOptions& options,
                              Ray ray, double distance, RayCounts& counts) {
  if (!options.shadows) return Rgb(1);
  if (!scene.has_transmissive_objects && !options.model_everything) {
    ++counts.shadow;
    return Rgb(tree.occluded(ray, distance) ? 0 : 1);
  }
  PartialRgb left(Rgb(1));
  for (;;) {
    ++counts.shadow;
    const Hit hit = tree.closest(ray, false);
    if (!hit || hit.t >= distance) return left;
    const Surface surface(scene, ray, hit, options.smooth_shading, options.model_everything);
    if (options.count_work && evaluates_maps(scene, scene.objects[hit.object], options.model_everything))
      ++counts.work.maps;
    const Material& material = surface.material();
    if (!material.transmits()) return Rgb(0);
    if (scene.rules.transmission_at_surfaces &&
        options.transmissive_shadows == TransmissiveShadows::distance) {
      left = left * PartialRgb(material.transmissive);
    } else if (glm::dot(surface.normal(), ray.direction) > 0) {
      switch (options.transmissive_shadows) {
        case TransmissiveShadows::distance:
          left = left * transmittance(material.transmissive, surface.given().absorb, hit.t);
          break;
        case TransmissiveShadows::surface:
          left = left * material.transmissive;
          break;
        case TransmissiveShadows::none:
          break;
      }
    }
    // Where coordinates are so large that the step is lost in rounding, the same surface would be met for
    // ever.
    if (surface.point() == ray.origin) return left;
    ray = surface.leaving(ray.direction);
    distance -= hit.t;
  }
}

}  // namespace trace
