#include "geometry/triangle.hpp"

#include <algorithm>

#include "geometry/rounding.hpp"

namespace trace {
namespace {

// Sizes between which no product of the fast test underflows or overflows in a way that matters: three edges
// or two and the way to the origin stay above 2^-900, where 2^-1074, what underflow may lose, is nothing
// against the bounds below.
constexpr double smallest_size = 0x1p-300, largest_size = 0x1p300;

// With |d| <= 1 in each coordinate, edges of at most s, themselves rounded, and the way f from corner a to
// the origin: a component of d x ac is at most 2 s and off by gamma(3) 2 s; its product with f, summed, by
// gamma(7) 2 s |f|, where |f| sums the coordinates; the determinant likewise by gamma(7) 6 s^2. Their
// difference, which stands for the third edge, is off by all of these and its own roundings: less than 36 u s
// |f| + 54 u s^2. 64 u s (|f| + s) covers all.
constexpr double bound_factor = 64 * unit_roundoff;

}  // namespace

Triangle::Triangle(const Corners& corners)
    : a(corners.a),
      ab(corners.b - corners.a),
      ac(corners.c - corners.a),
      size(std::max(largest(ab), largest(ac))) {
  if (!(size >= smallest_size && size <= largest_size)) size = std::numeric_limits<double>::infinity();
}

Meeting meets(const Triangle& triangle, const Ray& ray, TriangleHit& hit) {
  const Vec3 p = glm::cross(ray.direction, triangle.ac);
  const double determinant = glm::dot(triangle.ab, p);
  const Vec3 from_a = ray.origin - triangle.a;
  const double bound = bound_factor * triangle.size * (sum_of_sizes(from_a) + triangle.size);

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
    if (t <= sum_of_sizes(normal) * ray.origin_error + t_bound) return Meeting::none;
  }
  if (!(u > bound && v > bound && u + v < whole - bound && whole > least_determinant(triangle))) {
    return Meeting::unsure;
  }
  const double inverse = 1.0 / determinant;
  hit = {t_dot * inverse, u_dot * inverse, v_dot * inverse};
  return hit.t > ray.least_t ? Meeting::hit : Meeting::none;
}

}  // namespace trace
