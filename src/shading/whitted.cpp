#include "shading/whitted.hpp"

#include "shading/local_shading.hpp"

namespace trace {

Rgb WhittedTracer::trace(const Ray& ray, int depth) const {
  ++counts_.primary;
  return trace(ray, Kind::visibility, depth).color;
}

WhittedTracer::Result WhittedTracer::trace(const Ray& ray, Kind kind, int depth) const {
  const Hit hit = tree_.closest(ray, options_.backface_culling && kind != Kind::refraction);
  if (!hit) return {scene_.cube_map ? scene_.cube_map->lookup(ray.direction) : Rgb(0), -1};
  const Surface surface(scene_, ray, hit, options_.smooth_shading);

  Rgb color = shade_locally(scene_, tree_, options_, surface, ray.direction, counts_);
  if (depth > 0 && is_finite(surface.normal())) {
    const bool inside = glm::dot(surface.normal(), ray.direction) > 0;
    if (surface.material().reflects() && (!inside || options_.internal_reflection)) {
      color += reflected(ray, surface, inside, depth);
    }
    if (surface.material().transmits()) color += refracted(ray, surface, inside, depth);
  }
  return {color, hit.t};
}

Rgb WhittedTracer::reflected(const Ray& ray, const Surface& surface, bool inside, int depth) const {
  const Material& material = surface.material();
  const Vec3 &d = ray.direction, &n = surface.normal();
  ++counts_.reflected;
  // Split along and across the normal, and not normalized again: this form is the one whose last bits show in
  // the course's pictures of cube maps.
  const Vec3 along = glm::dot(n, -d) * n;
  const Vec3 across = along + d;
  const Ray mirrored = surface.leaving(along + across);
  const Result seen = trace(mirrored, Kind::reflection, depth - 1);
  // Inside glass the light has come through it.
  if (inside && material.transmits()) {
    return material.reflective * glm::pow(material.transmissive, Rgb(seen.t)) * seen.color;
  }
  return material.reflective * seen.color;
}

Rgb WhittedTracer::refracted(const Ray& ray, const Surface& surface, bool inside, int depth) const {
  const Material& material = surface.material();
  const Vec3& d = ray.direction;
  const Vec3 n = inside ? -surface.normal() : surface.normal();
  const double index = luminance(material.index);
  const double eta = inside ? index : 1 / index;
  // Snell's law, split as in reflected().
  const Vec3 across = eta * (d - glm::dot(n, d) * n);
  const double k = 1 - glm::dot(across, across);
  if (!(k >= 0)) return Rgb(0);  // total internal reflection: only the reflected ray goes on
  ++counts_.refracted;
  const Ray bent = surface.leaving(across - std::sqrt(k) * n);
  const Result seen = trace(bent, Kind::refraction, depth - 1);
  // Beer's law with the material that is entered, over the way to whatever is hit next.
  if (inside) return seen.color;
  return glm::pow(material.transmissive, Rgb(seen.t)) * seen.color;
}

}  // namespace trace
