#include "shading/whitted.hpp"

#include "scene/sample_pattern.hpp"
#include "shading/foggy.hpp"
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
  const Result seen = trace(ray, Kind::visibility, depth, {});
  return in_fog(world_.scene().fog, ray, seen.color, seen.t);
}

WhittedTracer::Result WhittedTracer::trace(const Ray& ray, Kind kind, int depth, const Path& path) const {
  const Scene& scene = world_.scene();
  const bool cull = options_.backface_culling && !scene.rules.two_sided && kind != Kind::refraction;
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
        color += reflected(ray, surface, kind, inside, depth, weight);
      } else if (world_.traces_for_nothing()) {
        reflected(ray, surface, kind, inside, depth, weight);
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

// What is mirrored, of a glossy surface on the average over directions that are spread around the mirrored
// one. Only what the eye sees directly is glossy: further on, the mirrored direction stands for all.
WhittedTracer::Result WhittedTracer::mirrored(const Ray& ray, const Surface& surface, Kind kind, int depth,
                                              const Path& path) const {
  const Vec3 direction = mirrored_direction(ray.direction, surface.normal());
  const double spread = surface.given().glossiness;
  const int n = options_.light_samples;
  if (spread == 0 || n == 1 || kind != Kind::visibility) {
    ++counts_.reflected;
    return trace(surface.leaving(direction), Kind::reflection, depth - 1, path);
  }
  const double side = glm::dot(surface.normal(), direction);
  PartialRgb sum;
  double count = 0, way = 0;
  for (int k = 0; k < n * n; ++k) {
    const Vec3 off = glm::normalize(direction + spread * on_sphere(multi_jittered(n, k)));
    if (!(glm::dot(surface.normal(), off) * side > 0)) continue;  // into the surface
    ++counts_.reflected;
    const Result seen = trace(surface.leaving(off), Kind::reflection, depth - 1, path);
    sum += seen.color;
    way += seen.t;
    ++count;
  }
  if (count == 0) return {PartialRgb(), length_of_miss};
  return {sum * PartialRgb(Rgb(1 / count)), way / count};
}

PartialRgb WhittedTracer::reflected(const Ray& ray, const Surface& surface, Kind kind, bool inside, int depth,
                                    double weight) const {
  const Material& material = surface.material();
  // Inside glass the light has come through it.
  const bool in_glass = inside && material.transmits() && !world_.scene().rules.transmission_at_surfaces;
  if (options_.least_contribution > 0) weight *= largest(material.reflective);
  const Path path{weight, in_glass ? &material.transmissive : nullptr};
  if (is_too_faint(path.weight)) return {};
  const Result seen = mirrored(ray, surface, kind, depth, path);
  if (in_glass) {
    return material.reflective * transmittance(material.transmissive, surface.given().absorb, seen.t) *
           seen.color;
  }
  return material.reflective * seen.color;
}

PartialRgb WhittedTracer::refracted(const Ray& ray, const Surface& surface, bool inside, int depth,
                                    double weight) const {
  const Material& material = surface.material();
  const Vec3 n = inside ? -surface.normal() : surface.normal();
  const double index = luminance(material.index), air = world_.scene().rules.index_of_air;
  const std::optional<Vec3> direction =
      refracted_direction(ray.direction, n, inside ? index / air : air / index);
  if (!direction) return {};  // only the reflected ray goes on
  if (world_.scene().rules.transmission_at_surfaces) {
    if (options_.least_contribution > 0) weight *= largest(material.transmissive);
    if (is_too_faint(weight)) return {};
    ++counts_.refracted;
    const Result seen =
        trace(surface.leaving(*direction), Kind::refraction, depth - 1, Path{weight, nullptr});
    return PartialRgb(material.transmissive) * seen.color;
  }
  // Beer's law with the material that is entered, over the way to whatever is hit next.
  const bool into_glass = !inside && material.transmits();
  const Path path{weight, into_glass ? &material.transmissive : nullptr};
  if (is_too_faint(path.weight)) return {};
  ++counts_.refracted;
  const Ray bent = surface.leaving(*direction);
  const Result seen = trace(bent, Kind::refraction, depth - 1, path);
  if (!into_glass) return seen.color;
  return transmittance(material.transmissive, surface.given().absorb, seen.t) * seen.color;
}

bool WhittedTracer::is_too_faint(double weight) const {
  if (!(weight < options_.least_contribution)) return false;
  if (options_.count_work) ++counts_.work.faint;
  return true;
}

}  // namespace trace
