// The ray tree and local shading in any kind of number: docs/language.md, sections 6 to 8. What is undefined
// there is NaN here.
#pragma once

#include "precision/light.hpp"
#include "precision/surface.hpp"
#include "shading/options.hpp"
#include "shading/ray_counts.hpp"
#include "shading/secondary_direction.hpp"

namespace trace::precision {

template <class T>
class WhittedTracer {
 public:
  // Refers to its arguments, which must outlive it. `counts` is for one thread.
  WhittedTracer(const SceneIn<T>& scene, const Search<T>& search, const ShadingOptions& options,
                RayCounts& counts)
      : scene_(scene), search_(search), options_(options), counts_(counts) {}

  // The colour seen along a primary ray with at most `depth` bounces.
  Vec3<T> trace(const Ray<T>& ray, int depth) const {
    ++counts_.primary;
    return trace(ray, options_.backface_culling, depth).color;
  }

 private:
  struct Result {
    Vec3<T> color;
    T t;
  };

  Result trace(const Ray<T>& ray, bool cull, int depth) const;
  Vec3<T> reflected(const Ray<T>& ray, const Surface<T>& surface, bool inside, int depth) const;
  Vec3<T> refracted(const Ray<T>& ray, const Surface<T>& surface, bool inside, int depth) const;
  Vec3<T> shade(const Surface<T>& surface, const Vec3<T>& toward_surface) const;
  Vec3<T> shadow(Ray<T> ray, T distance) const;

  static Vec3<T> transmittance(const Vec3<T>& kt, T length) { return glm::pow(kt, Vec3<T>(length)); }

  const SceneIn<T>& scene_;
  const Search<T>& search_;
  const ShadingOptions& options_;
  RayCounts& counts_;
};

template <class T>
typename WhittedTracer<T>::Result WhittedTracer<T>::trace(const Ray<T>& ray, bool cull, int depth) const {
  const bool leads_somewhere = is_finite(ray.origin) && is_finite(ray.direction) && !is_zero(ray.direction);
  const Hit<T> hit = leads_somewhere ? search_.closest(ray, cull) : Hit<T>();
  if (!hit) {
    const auto& sky = scene_.given.cube_map;
    return {sky ? sky->template lookup_in<T>(ray.direction) : Vec3<T>(0), -1};
  }
  const Surface<T> surface(scene_, ray, hit, options_.smooth_shading);
  Vec3<T> color = shade(surface, ray.direction);
  if (depth > 0 && is_finite(surface.normal())) {
    const bool inside = glm::dot(surface.normal(), ray.direction) > 0;
    if (surface.material().reflects() && (!inside || options_.internal_reflection)) {
      color += reflected(ray, surface, inside, depth);
    }
    if (surface.material().transmits()) color += refracted(ray, surface, inside, depth);
  }
  return {color, hit.t};
}

template <class T>
Vec3<T> WhittedTracer<T>::reflected(const Ray<T>& ray, const Surface<T>& surface, bool inside,
                                    int depth) const {
  const BasicMaterial<T>& material = surface.material();
  ++counts_.reflected;
  const Ray<T> mirrored = surface.leaving(mirrored_direction(ray.direction, surface.normal()));
  const Result seen = trace(mirrored, options_.backface_culling, depth - 1);
  if (!inside || !material.transmits()) return material.reflective * seen.color;
  return material.reflective * transmittance(material.transmissive, seen.t) * seen.color;
}

template <class T>
Vec3<T> WhittedTracer<T>::refracted(const Ray<T>& ray, const Surface<T>& surface, bool inside,
                                    int depth) const {
  const BasicMaterial<T>& material = surface.material();
  const Vec3<T> n = inside ? -surface.normal() : surface.normal();
  const T index = luminance(material.index);
  const auto direction = refracted_direction(ray.direction, n, inside ? index : 1 / index);
  if (!direction) return Vec3<T>(0);
  ++counts_.refracted;
  const Result seen = trace(surface.leaving(*direction), false, depth - 1);
  return inside ? seen.color : transmittance(material.transmissive, seen.t) * seen.color;
}

template <class T>
Vec3<T> WhittedTracer<T>::shade(const Surface<T>& surface, const Vec3<T>& toward_surface) const {
  const BasicMaterial<T>& material = surface.material();
  Vec3<T> color = material.emissive + material.ambient * scene_.ambient;
  const bool transmits = material.transmits();
  Vec3<T> normal = surface.normal();
  if (!is_finite(surface.point()) || !is_finite(normal)) return color;
  if (glm::dot(normal, toward_surface) > 0) {
    if (!transmits) return color;
    normal = -normal;
  }
  const T shininess = luminance(material.shininess);
  const bool may_skip = !scene_.given.shadow_may_be_undefined && shininess >= 0;
  if (may_skip && is_zero(material.diffuse) && is_zero(material.specular)) return color;
  for (const Light& light : scene_.given.lights) {
    const LightSample<T> to = std::visit([&](const auto& l) { return sample(l, surface.point()); }, light);
    const Vec3<T> light_color(std::visit([](const auto& l) -> const Rgb& { return l.color; }, light));
    if (!to.reaches) continue;
    const T cosine = glm::dot(normal, to.towards), lit = std::max(T(0), cosine);
    const bool from_behind = options_.backface_specular && transmits && cosine < 0;
    const Vec3<T> highlight =
        from_behind ? glm::normalize(-2 * cosine * normal - to.towards) : 2 * lit * normal - to.towards;
    const T specular = std::pow(std::max(T(0), glm::dot(highlight, -toward_surface)), shininess);
    const Vec3<T> share =
        material.diffuse * (transmits ? std::abs(cosine) : lit) + material.specular * specular;
    if (may_skip && is_zero(share)) continue;
    color += light_color * to.attenuation * shadow(surface.leaving(to.towards), to.distance) * share;
  }
  return color;
}

template <class T>
Vec3<T> WhittedTracer<T>::shadow(Ray<T> ray, T distance) const {
  if (!options_.shadows) return Vec3<T>(1);
  if (!scene_.given.has_transmissive_objects) {
    ++counts_.shadow;
    return Vec3<T>(search_.occluded(ray, distance) ? 0 : 1);
  }
  Vec3<T> left(1);
  for (;;) {
    ++counts_.shadow;
    const Hit<T> hit = search_.closest(ray, false);
    if (!hit || hit.t >= distance) return left;
    const Surface<T> surface(scene_, ray, hit, options_.smooth_shading);
    if (!surface.material().transmits()) return Vec3<T>(0);
    if (glm::dot(surface.normal(), ray.direction) > 0) {
      left *= transmittance(surface.material().transmissive, hit.t);
    }
    if (surface.point() == ray.origin) return left;  // the step is lost in rounding
    ray = surface.leaving(ray.direction);
    distance -= hit.t;
  }
}

}  // namespace trace::precision
