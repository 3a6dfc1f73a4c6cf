// The space of an object: its place in the world, and rays carried into it.
#pragma once

#include "geometry/ray.hpp"

namespace trace {

// Built once for each place in the scene graph and shared by the objects there.
struct Frame {
  Mat4 to_world;
  Mat4 to_object;        // inverse by cofactors times 1/det
  Mat3 normal_to_world;  // transpose of the inverse of the upper 3x3

  explicit Frame(const Mat4& placement);

  // Whether the inverse exists. Objects in a frame without one are not drawn (zero scale, rotation about a
  // zero axis, singular transform).
  bool invertible() const;

  Vec3 world_normal(const Vec3& n) const { return glm::normalize(normal_to_world * n); }
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
    ray = {origin, glm::normalize(along)};
  }
};

}  // namespace trace
