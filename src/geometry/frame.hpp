// The space of an object: its place in the world, and rays carried into it.
#pragma once

#include "geometry/ray.hpp"
#include "geometry/rounding.hpp"

namespace trace {

// Built once for each place in the scene graph and shared by the objects there.
struct Frame {
  Mat4 to_world;
  Mat4 to_object;        // inverse by cofactors times 1/det
  Mat3 normal_to_world;  // transpose of the inverse of the upper 3x3

  double to_object_stretch = 1;  // largest row sum of |upper 3x3|
  double to_world_stretch = 1;

  explicit Frame(const Mat4& placement);
  double error(double size) const { return relative_error_ * size + error_at_origin_; }

  // Whether the inverse exists. Objects in a frame without one are not drawn (zero scale, rotation about a
  // zero axis, singular transform).
  bool invertible() const;

  Vec3 world_normal(const Vec3& n) const { return glm::normalize(normal_to_world * n); }

 private:
  double relative_error_ = 0, error_at_origin_ = 0;
};

// A world ray in the space of an object. The direction is of unit length there, so a t found along it is
// `scale` times the t in the world.
struct ObjectRay {
  Ray ray;
  double scale = 1;

  ObjectRay(const Frame& frame, const Ray& world) {
    const Vec3 origin(frame.to_object * Vec4(world.origin, 1));
    const Vec3 end(frame.to_object * Vec4(world.origin + world.direction, 1));
    const Vec3 along = end - origin;
    scale = glm::length(along);
    const double error = frame.to_object_stretch * world.origin_error + frame.error(largest(world.origin));
    ray = {origin, glm::normalize(along), error, world.least_t * scale};
  }
};

}  // namespace trace
