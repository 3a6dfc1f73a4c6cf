// A torus about the z axis: the places at `minor` from the circle of radius `major` in the plane z = 0.
//
// Where minor is the larger (a spindle torus) it is the outer surface of the solid that the moving disk
// sweeps, dimpled at the axis; the lemon inside is not part of it.
//
// A ray's crossings are the sign changes of F(p) = sqrt((sqrt(x^2 + y^2) - major)^2 + z^2) - minor, the
// distance from the surface, which has no cancellation beyond the rounding of p. What separates them is the
// quartic that F's zeros are among. With t from the point c nearest to the centre (nearest_point.hpp) it has
// no cubic term,
//
//   g(t) = (t^2 + K)^2 - 4 R^2 (A t^2 + 2 B t + C),  K = c.c + R^2 - r^2,
//   A = dx^2 + dy^2, B = cx dx + cy dy, C = cx^2 + cy^2,
//
// and terms of the size of R^4 only. Between two zeros of g' / 4 = t^3 + (K - 2 R^2 A) t - 2 R^2 B g is
// monotonic, so F changes its sign at most once there, and bisection with Newton steps cannot lose the
// crossing. A zero of g' that is a little off changes F there by the square of that: it decides only rays
// that touch the surface, within the rounding of F.
//
// Error: with R + r = s a hit's place is within 16 u (s + |t|) of the surface, u = 2^-53: 3 u |t| for the
// rounding of t where it is far, the rest of c, of p and of F near the torus. Tests in tests/hard ask that of
// 113 digits.
#pragma once

#include "geometry/bounds.hpp"

namespace trace {

class Torus {
 public:
  // Both greater than 0 and finite, and so is their sum.
  Torus(double major, double minor);

  double major() const { return major_; }
  double minor() const { return minor_; }

  Bounds bounds() const {
    const Vec3 reach(major_ + minor_, major_ + minor_, minor_);
    return {-reach, reach};
  }

  // The normal points outward and has unit length.
  bool intersect(const Ray& ray, LocalHit& hit) const;

  // From the surface.
  double distance(const Vec3& p, const Vec3& normal) const;

  // u goes round the axis as the cylinder's, v round the tube: 1/4 below, 1/2 outside, 3/4 above, 0 and 1 on
  // the inside.
  Vec2 texture_coordinates(const Vec3& p, const Vec3& normal) const;

 private:
  double major_, minor_;
  double unit_;  // a power of two by which sizes are multiplied, so that powers of them stay in range
};

}  // namespace trace
