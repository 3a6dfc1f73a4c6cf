// What exact arithmetic says of a ray and a triangle: the truth that the forms are held against.
//
// The ray and the corners are taken as the numbers they are. Signs are decided in __float128 (113 bits,
// exponents that no product of doubles leaves) where its error bound allows, else in integers of the GMP
// library, which do not round.
#pragma once

#include "geometry/triangle.hpp"

namespace trace::hard {

// The sign (-1, 0, 1) of direction . ((p - origin) x (q - origin)): on which side of the line through p and q
// the ray passes.
int edge_sign(const Ray& ray, const Vec3& p, const Vec3& q);

// The signs of the edges bc, ca and ab.
struct EdgeSigns {
  int bc, ca, ab;

  bool inside() const {
    const bool negative = bc < 0 || ca < 0 || ab<0, positive = bc> 0 || ca > 0 || ab > 0;
    return negative != positive;  // both: beyond an edge; neither: the ray lies in the plane
  }
  int zeros() const { return (bc == 0) + (ca == 0) + (ab == 0); }
  int orientation() const { return bc + ca + ab > 0 ? 1 : -1; }  // of a triangle that is hit
};
EdgeSigns edge_signs(const Ray& ray, const Corners& triangle);

// Whether the line of the ray passes through the triangle, edges and corners included.
bool line_hits(const Ray& ray, const Corners& triangle);

// The t at which the ray meets the plane of the triangle, rounded once from __float128, whose error is some
// 2^-110 times the condition of the plane.
double plane_t(const Ray& ray, const Corners& triangle);

}  // namespace trace::hard
