#include "shading/whitted.hpp"

#include "shading/local_shading.hpp"
#include "shading/secondary_direction.hpp"
#include "shading/transmittance.hpp"

namespace trace {
namespace {

bool leads_somewhere(const Ray& ray) {
  return all_finite(ray.origin * 0.0 + ray.direction) && !is_zero(ray.direction);
}

}  // namespace

PartialRgb WhittedTracer::trace(const Ray& ray, int depth) const {
  ++counts_.primary;
  return trace(ray, Kind::visibility, depth).color;
}

WhittedTracer::Result WhittedTracer::trace(const Ray& ray, Kind kind, int depth) const {
  const bool cull = options_.backface_culling && kind != Kind::refraction;
  const Hit hit = leads_somewhere(ray) ? tree_.closest(ray, cull) : Hit();
  if (!hit) return {scene_.cube_map ? scene_.cube_map->lookup(ray.direction) : Rgb(0), length_of_miss};
  const Surface surface(scene_, ray, hit, options_.smooth_shading);

  PartialRgb color = shade_locally(scene_, tree_, options_, surface, ray.direction, counts_);
  if (depth > 0 && is_finite(surface.normal())) {
    const bool inside = glm::dot(surface.normal(), ray.direction) > 0;
    if (surface.material().reflects() && (!inside || options_.internal_reflection)) {
      color += reflected(ray, surface, inside, depth);
    }
    if (surface.material().transmits()) color += refracted(ray, surface, inside, depth);
  }
  return {color, hit.t};
}

PartialRgb WhittedTracer::reflected(const Ray& ray, const Surface& surface, bool inside, int depth) const {
  const Material& material = surface.material();
  ++counts_.reflected;
  const Ray mirrored = surface.leaving(mirrored_direction(ray.direction, surface.normal()));
  const Result seen = trace(mirrored, Kind::reflection, depth - 1);
  // Inside glass the light has come through it.
  if (inside && material.transmits()) {
    return material.reflective * transmittance(material.transmissive, seen.t) * seen.color;
  }
  return material.reflective * seen.color;
}

PartialRgb WhittedTracer::refracted(const Ray& ray, const Surface& surface, bool inside, int depth) const {
  const Material& material = surface.material();
  const Vec3 n = inside ? -surface.normal() : surface.normal();
  const double index = luminance(material.index);
  const std::optional<Vec3> direction = refracted_direction(ray.direction, n, inside ? index : 1 / index);
  if (!direction) return {};  // only the reflected ray goes on
  ++counts_.refracted;
  const Ray bent = surface.leaving(*direction);
  const Result seen = trace(bent, Kind::refraction, depth - 1);
  // Beer's law with the material that is entered, over the way to whatever is hit next.
  if (inside) return seen.color;
  return transmittance(material.transmissive, seen.t) * seen.color;
}

}  // namespace trace
