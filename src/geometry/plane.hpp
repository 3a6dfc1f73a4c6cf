// A plane without an end, seen from both sides.
#pragma once

#include "geometry/bounds.hpp"

namespace trace {

class Plane {
 public:
  // `normal` of any length but 0; both finite.
  Plane(const Vec3& point, const Vec3& normal);

  Bounds bounds() const { return Bounds::everything(); }

  // The normal faces the ray. A ray in the plane has no hit.
  bool intersect(const Ray& ray, LocalHit& hit) const;

  // From the plane, with the rounding of the given point and normal.
  double distance(const Vec3& p, const Vec3& normal) const;

  // A picture a unit square, from `point` on: u along the cross product of +y and the normal (+x where the
  // normal is along y), v along that of the normal and u's direction. For the plane z = 0 that is x and y.
  Vec2 texture_coordinates(const Vec3& p, const Vec3& normal) const;

 private:
  // Above the plane, and how far that is off for a p with coordinates off by `error`.
  struct Height {
    double value, unsure;
  };
  Height height(const Vec3& p, double error) const;

  Vec3 point_, normal_;
};

}  // namespace trace
