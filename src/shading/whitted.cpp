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
  return trace(ray, Kind::visibility, depth, {}).color;
}

WhittedTracer::Result WhittedTracer::trace(const Ray& ray, Kind kind, int depth, const Path& path) const {
  const Scene& scene = world_.scene();
  const bool cull = options_.backface_culling && kind != Kind::refraction;
  const Hit hit = leads_somewhere(ray) ? world_.tree().closest(ray, cull) : Hit();
  if (!hit) {
    const CubeMap* surroundings = world_.surroundings();
    if (!surroundings) return {Rgb(0), length_of_miss};
    if (options_.count_work) ++counts_.work.surroundings;
    return {surroundings->lookup(ray.direction), length_of_miss};
  }
  const Surface surface(scene, ray, hit, options_.smooth_shading, options_.model_everything);
  if (options_.count_work && evaluates_maps(scene, scene.objects[hit.object], options_.model_everything))
    ++counts_.work.maps;

  PartialRgb color = shade_locally(world_, surface, ray.direction, counts_);
  if (depth > 0 && is_finite(surface.normal())) {
    const Material& material = surface.material();
    const bool inside = glm::dot(surface.normal(), ray.direction) > 0;
    const double weight = options_.least_contribution > 0 ? path.weight_at(hit.t) : 1;
    if (!inside || options_.internal_reflection) {
      if (material.reflects()) {
        color += reflected(ray, surface, inside, depth, weight);
      } else if (world_.traces_for_nothing()) {
        reflected(ray, surface, inside, depth, weight);
      }
    }
    if (material.transmits()) {
      color += refracted(ray, surface, inside, depth, weight);
    } else if (world_.traces_for_nothing()) {
      refracted(ray, surface, inside, depth, weight);
    }
  }
  return {color, hit.t};
}

PartialRgb WhittedTracer::reflected(const Ray& ray, const Surface& surface, bool inside, int depth,
                                    double weight) const {
  const Material& material = surface.material();
  // Inside glass the light has come through it.
  const bool in_glass = inside && material.transmits();
  if (options_.least_contribution > 0) weight *= largest(material.reflective);
  const Path path{weight, in_glass ? &material.transmissive : nullptr};
  if (is_too_faint(path.weight)) return {};
  ++counts_.reflected;
  const Ray mirrored = surface.leaving(mirrored_direction(ray.direction, surface.normal()));
  const Result seen = trace(mirrored, Kind::reflection, depth - 1, path);
  if (in_glass) return material.reflective * transmittance(material.transmissive, seen.t) * seen.color;
  return material.reflective * seen.color;
}

PartialRgb WhittedTracer::refracted(const Ray& ray, const Surface& surface, bool inside, int depth,
                                    double weight) const {
  const Material& material = surface.material();
  const Vec3 n = inside ? -surface.normal() : surface.normal();
  const double index = luminance(material.index);
  const std::optional<Vec3> direction = refracted_direction(ray.direction, n, inside ? index : 1 / index);
  if (!direction) return {};  // only the reflected ray goes on
  // Beer's law with the material that is entered, over the way to whatever is hit next.
  const bool into_glass = !inside && material.transmits();
  const Path path{weight, into_glass ? &material.transmissive : nullptr};
  if (is_too_faint(path.weight)) return {};
  ++counts_.refracted;
  const Ray bent = surface.leaving(*direction);
  const Result seen = trace(bent, Kind::refraction, depth - 1, path);
  if (!into_glass) return seen.color;
  return transmittance(material.transmissive, seen.t) * seen.color;
}

bool WhittedTracer::is_too_faint(double weight) const {
  if (!(weight < options_.least_contribution)) return false;
  if (options_.count_work) ++counts_.work.faint;
  return true;
}

}  // namespace trace
