// The surface at a hit, in any kind of number, and rays that leave it.
//
// How far a hit's point may be from its surface is measured rather than bounded: the point is carried into
// the space of the object and its distance from the surface computed there. What that leaves open are the
// roundings of carrying it (products and sums, three a term: gamma(3) of the terms' sizes) and of the
// distance (a few of the coordinates): 8 u of the terms and coordinates covers them. Along the unit normal n
// of the object's space, with N the transpose of the inverse, a displacement e there is one of n.e / |N n|
// along the normal of the world. Of a ray that leaves the surface at a cosine, point and surface are each off
// by that height; with as much again for the other's rounding, hits up to 4 height / cosine are of the
// surface itself. A cosine below the root of u says only that the ray runs in the surface. So there is no
// fixed epsilon: in floats at coordinates of 1000 it is about a thousandth, in doubles 1e-12.
#pragma once

#include "precision/search.hpp"
#include "scene/material_maps.hpp"

namespace trace::precision {

template <class T>
class Surface {
 public:
  // `smooth`: use the vertex normals of meshes that have them.
  Surface(const SceneIn<T>& scene, const Ray<T>& ray, const Hit<T>& hit, bool smooth);
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  const Vec3<T>& point() const { return point_; }
  const Vec3<T>& normal() const { return normal_; }  // as shading/surface.hpp
  const BasicMaterial<T>& material() const { return *material_; }

  Ray<T> leaving(const Vec3<T>& direction) const {
    const T cosine = std::max(std::abs(glm::dot(facing_, direction)), root_of_roundoff<T>());
    return {point_, direction, 4 * height_ / cosine};
  }

 private:
  Vec3<T> point_, normal_;
  Vec3<T> facing_;  // at right angles to the surface
  T height_;
  BasicMaterial<T> own_;
  const BasicMaterial<T>* material_;
};

template <class T>
Surface<T>::Surface(const SceneIn<T>& scene, const Ray<T>& ray, const Hit<T>& hit, bool smooth)
    : point_(ray.at(hit.t)) {
  const ObjectIn<T>& object = scene.objects[hit.object];
  const FrameIn<T>& frame = scene.frames[object.frame];
  const BasicMappedMaterial<T>& material = scene.materials[object.material];
  const Vec3<T> p = frame.point_to_object(point_);
  Vec3<T> normal = hit.local.normal, facing_there = normal;
  Vec3<T> terms = frame.terms_of_point(point_) + glm::abs(p);
  T off = 0;
  material_ = &material.values;
  if (const auto* id = std::get_if<MeshId>(&object.shape)) {
    const MeshIn<T>& mesh = scene.meshes[id->index];
    const FaceCorners& corners = mesh.given->faces[hit.local.part];
    const Triangle<T> triangle = mesh.triangle(corners);
    normal = facing_there = triangle.normal();
    off = std::abs(glm::dot(facing_there, p - triangle.a));
    terms += glm::abs(triangle.a);
    if (smooth && mesh.given->smooth()) normal = mesh.smooth_normal(corners, hit.local.uv);
    if (!mesh.materials.empty()) {
      own_ = mesh.material_at(corners, hit.local.uv);
      material_ = &own_;
    }
  } else {
    std::visit(
        [&](const auto& shape) {
          using S = std::decay_t<decltype(shape)>;
          if constexpr (!std::is_same_v<S, MeshId>) off = distance(shape, p, normal);
          if constexpr (std::is_same_v<S, ConeIn<T>>) facing_there = precision::facing(normal);
        },
        object.shape);
    if (material.has_maps()) {
      own_ = at_point(material, scene.given.textures, hit.local.uv);
      material_ = &own_;
    }
  }
  const Vec3<T> carried = frame.normal_to_world * facing_there;
  const T stretch = glm::length(carried);
  facing_ = carried / stretch;
  normal_ = normal == facing_there ? facing_ : glm::normalize(frame.normal_to_world * normal);
  height_ = (off + 8 * unit_roundoff<T> * glm::dot(glm::abs(facing_there), terms)) / stretch;
}

}  // namespace trace::precision
