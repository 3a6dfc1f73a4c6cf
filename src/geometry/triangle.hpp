// Ray against triangle, without gaps between triangles that share an edge.
#pragma once

#include "geometry/ray.hpp"

namespace trace {

// Corners in the space of the mesh.
struct Corners {
  Vec3 a, b, c;
};

// What the fast test uses: corner a and the edges to b and c, as rounded, and the largest coordinate of the
// edges; infinite where the edges are so short or long that products could underflow or overflow, which sends
// every ray to the exact test.
struct Triangle {
  Vec3 a, ab, ac;
  double size;

  explicit Triangle(const Corners& corners);
};

struct TriangleHit {
  double t, u, v;  // u and v weigh the second and third corner
};

enum class Meeting { none, hit, gap, edge_gap, unsure };

// Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", JGT 2(1) 1997, in the very form of
// the course's renderer, wherever no rounding can decide: a hit is then within the edges, ahead of the origin
// and not in the plane of the triangle (Ray::origin_error). Else it is `unsure`, and meets_exactly() must
// decide.
Meeting meets(const Triangle& triangle, const Ray& ray, TriangleHit& hit);

// The same by exact arithmetic on the ray and the corners as they are given: edges included, so that a ray
// that passes exactly through an edge or a corner crosses every triangle there, and one beside it crosses
// exactly the one on its side, whatever the order of corners. t, u and v are within a few roundings.
bool crosses_exactly(const Corners& corners, const Ray& ray, TriangleHit& hit);

// For what meets() leaves open: a `hit` where the course's form says so, a `gap` where it does not though the
// ray crosses the triangle, an `edge_gap` where it does so exactly in an edge or corner. What becomes of gaps
// is decided by what else there is at the same place (acceleration/mesh_gaps.hpp).
Meeting meets_after_all(const Corners& corners, const Ray& ray, TriangleHit& hit);

// Whether a hit, if any, is as near to a gap along the ray as two that are well determined and should be
// equal: off by some 2^-50 each.
inline bool same_place(double t, double gap_t) {
  return std::abs(t - gap_t) <= 0x1p-40 * gap_t;
}

// Where the determinant, six times the volume of the direction and the triangle's edges, is no larger, t as a
// quotient would not be within 2^-23 of where the hit is along the ray: thin triangles, grazing rays.
inline double least_determinant(const Triangle& triangle) {
  return 0x1p-23 * triangle.size * triangle.size;
}

// Unit normal, counter-clockwise corners facing the viewer. Not finite for a triangle without area.
inline Vec3 face_normal(const Triangle& triangle) {
  return glm::normalize(glm::cross(triangle.ab, triangle.ac));
}

}  // namespace trace
