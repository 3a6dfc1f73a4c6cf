// Ray against triangle, without gaps between triangles that share an edge.
#pragma once

#include <limits>

#include "geometry/ray.hpp"
#include "geometry/rounding.hpp"

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

  explicit Triangle(const Corners& corners)
      : a(corners.a),
        ab(corners.b - corners.a),
        ac(corners.c - corners.a),
        size(size_of(largest(ab), largest(ac))) {}

 private:
  // Between 2^-300 and 2^300 no product of the fast test underflows or overflows in a way that matters: three
  // edges or two and the way to the origin stay above 2^-900, where 2^-1074, what underflow may lose, is
  // nothing against the bounds of meets().
  static double size_of(double of_ab, double of_ac) {
    const double size = of_ab < of_ac ? of_ac : of_ab;
    return size >= 0x1p-300 && size <= 0x1p300 ? size : std::numeric_limits<double>::infinity();
  }
};

struct TriangleHit {
  double t, u, v;  // u and v weigh the second and third corner
};

enum class Meeting { none, hit, gap, edge_gap, unsure };

// Where the determinant, six times the volume of the direction and the triangle's edges, is no larger, t as a
// quotient would not be within 2^-23 of where the hit is along the ray: thin triangles, grazing rays.
inline double least_determinant(const Triangle& triangle) {
  return 0x1p-23 * triangle.size * triangle.size;
}

// Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", JGT 2(1) 1997, in the very form of
// the course's renderer. `none` is certain: no rounding can have put a ray that crosses the triangle beside
// it; or the hit is beyond `limit`, or the origin cannot be told from lying in the plane (Ray::origin_error).
// `hit` is what the course's form says. Where neither holds, meets_after_all() must decide.
// `reach` is at least the sum of sizes of ray.origin - triangle.a.
inline Meeting meets(const Triangle& triangle, const Ray& ray, double reach, double limit, TriangleHit& hit) {
  const Vec3 p = glm::cross(ray.direction, triangle.ac);
  const double determinant = glm::dot(triangle.ab, p);
  const Vec3 from_a = ray.origin - triangle.a;
  // With |d| <= 1 in each coordinate, edges of at most s, themselves rounded, and the way f from corner a to
  // the origin: a component of d x ac is at most 2 s and off by gamma(3) 2 s; its product with f, summed, by
  // gamma(7) 2 s |f|, where |f| sums the coordinates; the determinant likewise by gamma(7) 6 s^2. Their
  // difference, which stands for the third edge, is off by all of these and its own roundings: less than 36 u
  // s |f| + 54 u s^2. 64 u s (|f| + s) covers all.
  const double bound = 64 * unit_roundoff * triangle.size * (reach + triangle.size);

  // Weights times the determinant, all with its sign taken away. The comparisons are such that an infinite or
  // undefined number leads to `unsure`.
  const double sign = determinant < 0 ? -1.0 : 1.0;
  const double whole = determinant * sign;
  const double u_dot = glm::dot(from_a, p);
  const double u = u_dot * sign;
  if (u < -bound || u > whole + bound) return Meeting::none;
  const Vec3 q = glm::cross(from_a, triangle.ab);
  const double v_dot = glm::dot(ray.direction, q);
  const double v = v_dot * sign;
  if (v < -bound || u + v > whole + bound) return Meeting::none;

  // t times the determinant is off by gamma(7) 2 s^2 |f|.
  const double t_dot = glm::dot(triangle.ac, q);
  const double t = t_dot * sign, t_bound = bound * triangle.size;
  if (t < -t_bound) return Meeting::none;
  // Does the origin lie in the plane, as far as is known? Its normal ab x ac is at most 2 s^2 in each
  // coordinate, so 6 s^2 bounds their sum.
  if (!(t > t_bound + 6 * triangle.size * triangle.size * ray.origin_error)) {
    if (!(ray.origin_error > 0 && t_bound < std::numeric_limits<double>::infinity())) return Meeting::unsure;
    const Vec3 normal = glm::cross(triangle.ab, triangle.ac);
    const double own_reach = sum_of_sizes(from_a) + triangle.size;  // so that `reach` does not decide
    const double own_bound = 64 * unit_roundoff * triangle.size * own_reach * triangle.size;
    if (t <= sum_of_sizes(normal) * ray.origin_error + own_bound) return Meeting::none;
  }
  const double inverse = 1.0 / determinant;
  hit = {t_dot * inverse, u_dot * inverse, v_dot * inverse};
  if (!(whole > least_determinant(triangle))) return Meeting::unsure;
  // 2^-23 of t and of the way to the triangle, with room.
  if (hit.t > limit + 0x1p-20 * (limit + reach)) return Meeting::none;
  // Next to an edge the course's form decides if it says hit.
  const bool is_certain = u > bound && v > bound && u + v < whole - bound;
  if (!is_certain && !(hit.u >= 0 && hit.u <= 1 && hit.v >= 0 && hit.u + hit.v <= 1)) return Meeting::unsure;
  return hit.t > ray.least_t ? Meeting::hit : Meeting::none;
}

// Of one triangle alone.
inline Meeting meets(const Triangle& triangle, const Ray& ray, TriangleHit& hit) {
  const double reach = sum_of_sizes(ray.origin - triangle.a);
  return meets(triangle, ray, reach, std::numeric_limits<double>::infinity(), hit);
}

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

// Unit normal, counter-clockwise corners facing the viewer. Not finite for a triangle without area.
inline Vec3 face_normal(const Triangle& triangle) {
  return glm::normalize(glm::cross(triangle.ab, triangle.ac));
}

}  // namespace trace
