// The cylinder x^2 + y^2 = 1, 0 <= z <= 1, with both caps or as an open tube.
#pragma once

#include "geometry/bounds.hpp"

namespace trace {

struct Cylinder {
  Bounds bounds() const { return {Vec3(-1, -1, 0), Vec3(1, 1, 1)}; }

  // The side where it is strictly nearer than the caps, else the caps. Normals point outward.
  bool intersect(const Ray& ray, LocalHit& hit) const;

  // From the side or the cap that the normal of a hit belongs to.
  double distance(const Vec3& p, const Vec3& normal) const;

  // On the side u goes round from -x by -y, +x and +y, v up with z; a cap shows the square around it from
  // (-1, -1) to (1, 1).
  Vec2 texture_coordinates(const Vec3& p, const Vec3& normal) const;

 private:
  bool intersect_caps(const Ray& ray, LocalHit& hit) const;
  // Of rays that certainly cross the cylinder though they meet neither.
  bool intersect_across_rim(const Ray& ray, bool leaves, LocalHit& hit) const;
};

// The cylinder without caps, seen from both sides.
struct Tube {
  Bounds bounds() const { return Cylinder{}.bounds(); }

  // As the side of the cylinder; the normal faces the ray.
  bool intersect(const Ray& ray, LocalHit& hit) const;
  double distance(const Vec3& p, const Vec3& normal) const { return Cylinder{}.distance(p, normal); }
  Vec2 texture_coordinates(const Vec3& p, const Vec3& normal) const {
    return Cylinder{}.texture_coordinates(p, normal);
  }
};

}  // namespace trace
