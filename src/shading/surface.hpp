// The surface at a hit: where, which way it faces, what it is made of.
#pragma once

#include "acceleration/scene_tree.hpp"

namespace trace {

// Cosines smaller than this say only that a ray runs in a surface.
inline constexpr double least_cosine = 0x1p-36;

class Surface {
 public:
  // `smooth`: use the vertex normals of meshes that have them.
  Surface(const Scene& scene, const Ray& ray, const Hit& hit, bool smooth);
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  const Vec3& point() const { return point_; }
  // Unit length, as the primitive delivers it: outward, or whichever way a smooth mesh says. Not finite where
  // a mesh gives no direction (vertex normals that cancel, generated normals of a face without area).
  const Vec3& normal() const { return normal_; }
  const Material& material() const { return *material_; }

  // The ray from the point on, to either side. It starts exactly at the point, as the course's do, and knows
  // how far that may be from the true one.
  Ray leaving(const Vec3& direction) const;

 private:
  Vec3 point_;
  Vec3 normal_;
  Vec3 facing_;               // the normal of the surface as it is, where `normal_` is interpolated
  double height_;             // how far the point may be from the surface, in each coordinate
  double point_error_;        // how far from where the ray meets the surface
  Material own_;              // filled where the material varies over the surface
  const Material* material_;  // own_ or the scene's
};

}  // namespace trace
