// The surface at a hit: where, which way it faces, what it is made of.
#pragma once

#include "acceleration/scene_tree.hpp"
#include "scene/material_maps.hpp"

namespace trace {

// Cosines smaller than this say only that a ray runs in a surface.
inline constexpr double least_cosine = 0x1p-36;

// Whether the material of an object is evaluated through its maps at each point; `always` where it has none
// too, for nothing. The material of a mesh whose points have their own is mixed from theirs; on one without
// texture coordinates pictures have no place.
inline bool evaluates_maps(const Scene& scene, const Object& object, bool always) {
  const MappedMaterial& material = scene.materials[object.material];
  const auto* id = std::get_if<MeshId>(&object.shape);
  if (!id) return material.has_maps() || always;
  const SceneMesh& mesh = scene.meshes[id->index];
  if (!mesh.materials.empty()) return false;
  if (!material.has_maps()) return always;
  return mesh.geometry.has_coordinates() || has_solid_maps(material, scene.textures);
}

class Surface {
 public:
  // `smooth`: use the vertex normals of meshes that have them. `always_maps`: as evaluates_maps().
  Surface(const Scene& scene, const Ray& ray, const Hit& hit, bool smooth, bool always_maps = false);
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  const Vec3& point() const { return point_; }
  // Unit length, as the primitive delivers it: outward, or whichever way a smooth mesh says; turned by maps
  // of heights and normals, but to the same side of the ray (mapped_normal()). Not finite where a mesh gives
  // no direction (vertex normals that cancel, generated normals of a face without area).
  const Vec3& normal() const { return normal_; }
  const Material& material() const { return *material_; }
  // What of the material is the same all over the object.
  const MappedMaterial& given() const { return *given_; }

  // The ray from the point on, to either side. It starts exactly at the point, as the course's do, and knows
  // how far that may be from the true one.
  Ray leaving(const Vec3& direction) const;

 private:
  Vec3 point_;
  Vec3 normal_;
  Vec3 facing_;               // the normal of the surface as it is, where `normal_` is interpolated or turned
  double height_;             // how far the point may be from the surface, in each coordinate
  double least_way_;          // DialectRules::least_way
  double point_error_;        // how far from where the ray meets the surface
  Material own_;              // filled where the material varies over the surface
  const Material* material_;  // own_ or the scene's
  const MappedMaterial* given_;
};

}  // namespace trace
