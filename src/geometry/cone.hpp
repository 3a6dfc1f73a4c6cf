// A cone or truncated cone around the z axis, from z = 0 to z = height, as the course draws it.
//
// Side: x^2 + y^2 = B^2 (z + g)^2 with B the slope of the radius and -g the height of the apex. Three habits
// of the course's renderer are kept because its pictures show them: the z part of the side's normal is twice
// too large, the far root is taken even where the near one is nearer and good, and the cap at z = height
// faces into the cone (that at z = 0 faces the ray). Habits::none is a cone without them: the nearest place
// counts, and normals are at right angles to the surface and outward.
#pragma once

#include "geometry/bounds.hpp"
#include "geometry/quadratic.hpp"

namespace trace {

class Cone {
 public:
  // Radii are used without sign and are at least 1e-4; a cone of negative height is never hit.
  enum class Habits { course, none };
  Cone(double bottom_radius, double top_radius, double height, bool capped, Habits habits = Habits::course);

  Bounds bounds() const;
  bool intersect(const Ray& ray, LocalHit& hit) const;

  // At right angles to the surface where a hit has `normal`, which on the side has twice the z part.
  Vec3 facing(const Vec3& normal) const {
    const bool on_side = habits_ == Habits::course && (normal.x != 0 || normal.y != 0);
    return {normal.x, normal.y, on_side ? 0.5 * normal.z : normal.z};
  }

  // From the side, or from the caps, whichever the normal of a hit belongs to; at least as much as the real
  // one.
  double distance(const Vec3& p, const Vec3& normal) const;

  // As the cylinder's, with v from 0 at z = 0 to 1 at z = height, and caps of their own radius.
  Vec2 texture_coordinates(const Vec3& p, const Vec3& normal) const;

  // What computing the same in other ways takes. Radii as used; x^2 + y^2 = slope^2 (z + apex_offset)^2.
  double bottom_radius() const { return bottom_radius_; }
  double top_radius() const { return top_radius_; }
  double height() const { return height_; }
  bool capped() const { return capped_; }
  double slope() const { return slope_; }
  double apex_offset() const { return apex_offset_; }

 private:
  // Where the ray meets the endless double cone; false where it does not, and where it only touches it.
  bool side_roots(const Ray& ray, const Vec3& from_apex, Roots& roots) const;

  double bottom_radius_, top_radius_, height_;
  bool capped_;
  Habits habits_;
  double slope_;        // B
  double apex_offset_;  // g
};

}  // namespace trace
