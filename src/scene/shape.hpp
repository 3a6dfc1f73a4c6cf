// What is asked of a shape of any kind that is not a mesh, by one ray.
#pragma once

#include "scene/scene.hpp"

namespace trace {

bool intersect(const Shape& shape, const Ray& ray, LocalHit& hit);

// Of a place with the normal of the hit there, with the rounding of the formula.
double distance_with_rounding(const Shape& shape, const Vec3& p, const Vec3& normal);

// Whether hits of the shape say themselves where they are in a texture.
inline bool tells_texture_coordinates(const Shape& shape) {
  return std::holds_alternative<Box>(shape) || std::holds_alternative<Square>(shape);
}

// Where `p`, in the space of the object, is in a texture; of shapes whose hits tell it, or that have no
// texture coordinates, what the hit says.
Vec2 texture_coordinates(const Shape& shape, const LocalHit& hit, const Vec3& p);

}  // namespace trace
