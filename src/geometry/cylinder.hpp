// The cylinder x^2 + y^2 = 1, 0 <= z <= 1, with both caps.
#pragma once

#include "geometry/bounds.hpp"

namespace trace {

struct Cylinder {
  Bounds bounds() const { return {Vec3(-1, -1, 0), Vec3(1, 1, 1)}; }

  // The side where it is strictly nearer than the caps, else the caps. Normals point outward.
  bool intersect(const Ray& ray, LocalHit& hit) const;

  // From the side or the cap that the normal of a hit belongs to.
  double distance(const Vec3& p, const Vec3& normal) const;

 private:
  // Rays along the axis have no hit here.
  bool intersect_side(const Ray& ray, LocalHit& hit) const;
  bool intersect_caps(const Ray& ray, LocalHit& hit) const;
  // Of rays that certainly cross the cylinder though they meet neither.
  bool intersect_across_rim(const Ray& ray, bool leaves, LocalHit& hit) const;
};

}  // namespace trace
