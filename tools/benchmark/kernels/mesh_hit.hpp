// Where a ray meets a mesh, and the rays from there: as shading/surface.hpp, but without materials and
// smoothing, which are not part of tracing rays.
#pragma once

#include "geometry/rounding.hpp"
#include "scene/scene.hpp"
#include "shading/surface.hpp"

namespace trace::bench {

class MeshHit {
 public:
  MeshHit(const Scene& scene, const Ray& ray, const Hit& hit) : point_(ray.at(hit.t)) {
    const Object& object = scene.objects[hit.object];
    const Frame& frame = scene.frames[object.frame];
    const Mesh& mesh = scene.meshes[std::get<MeshId>(object.shape).index].geometry;
    normal_ = frame.world_normal(face_normal(mesh.triangle(hit.local.part)));
    const double distance = mesh.distance(hit.local.part, Vec3(frame.to_object * Vec4(point_, 1)));
    height_ = frame.to_world_stretch * (distance + frame.error(largest(point_)));
    const double cosine = glm::dot(normal_, ray.direction);
    if (cosine > 0) normal_ = -normal_;
    point_error_ = height_ / std::max(std::abs(cosine), least_cosine);
  }

  const Vec3& point() const { return point_; }
  const Vec3& normal() const { return normal_; }  // unit length, towards where the ray came from

  // `direction` of unit length.
  Ray leaving(const Vec3& direction) const {
    const double cosine = std::abs(glm::dot(normal_, direction));
    return {point_, direction, point_error_, cosine > least_cosine ? 4 * height_ / cosine : 0};
  }

 private:
  Vec3 point_, normal_;
  double height_, point_error_;
};

}  // namespace trace::bench
