#include <algorithm>

#include "geometry/expansion.hpp"
#include "geometry/rounding.hpp"
#include "geometry/triangle.hpp"

namespace trace {
namespace {

struct ExactVector {
  Expansion x, y, z;
};

ExactVector difference(const Vec3& a, const Vec3& b) {
  return {Expansion::difference(a.x, b.x), Expansion::difference(a.y, b.y), Expansion::difference(a.z, b.z)};
}

ExactVector cross(const ExactVector& a, const ExactVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Expansion dot(const ExactVector& a, const ExactVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// A power of two that brings the coordinates near one, so that products neither overflow nor underflow.
double scale_of(const Corners& corners, const Vec3& origin) {
  const double size = std::max({largest(corners.a), largest(corners.b), largest(corners.c), largest(origin)});
  if (size == 0) return 1;
  return std::ldexp(1.0, std::clamp(-std::ilogb(size), -1022, 1022));
}

class Crossing {
 public:
  Crossing(const Corners& corners, const Ray& ray)
      : corners_(corners), ray_(ray), scale_(scale_of(corners, ray.origin)) {
    const Vec3 origin = scale_ * ray.origin;
    const ExactVector a = difference(scale_ * corners.a, origin), b = difference(scale_ * corners.b, origin),
                      c = difference(scale_ * corners.c, origin);
    const ExactVector d{ray.direction.x, ray.direction.y, ray.direction.z};
    w_ = dot(d, cross(b, c));
    u_ = dot(d, cross(c, a));
    v_ = dot(d, cross(a, b));
    whole_ = w_ + u_ + v_;
    height_ = dot(a, cross(b, c));
  }

  // Whether the plane of the triangle is ahead of the origin, and the origin not in it as far as is known.
  bool is_ahead() const {
    if (whole_.sign() == 0 || height_.sign() != whole_.sign()) return false;
    if (ray_.origin_error == 0) return true;
    const Vec3 normal =
        accurate_cross(scale_ * corners_.b - scale_ * corners_.a, scale_ * corners_.c - scale_ * corners_.a);
    return std::abs(height_.estimate()) > sum_of_sizes(normal) * (scale_ * ray_.origin_error);
  }

  bool is_within_edges() const {
    const int beyond = -whole_.sign();
    return w_.sign() != beyond && u_.sign() != beyond && v_.sign() != beyond;
  }

  bool is_on_edge() const { return w_.sign() == 0 || u_.sign() == 0 || v_.sign() == 0; }

  TriangleHit hit() const {
    const double whole = whole_.estimate();
    const double u = std::clamp(u_.estimate() / whole, 0.0, 1.0);
    return {height_.estimate() / whole / scale_, u, std::clamp(v_.estimate() / whole, 0.0, 1.0 - u)};
  }

 private:
  const Corners& corners_;
  const Ray& ray_;
  double scale_;
  Expansion w_, u_, v_;  // six times the signed volumes of the direction and each edge, opposite a, b and c
  Expansion whole_;      // their sum, for the whole triangle
  Expansion height_;     // t times whole_
};

// The course's own decision and numbers. `determined`: see meets().
bool course_meets(const Triangle& triangle, const Ray& ray, TriangleHit& hit, bool& determined) {
  const Vec3 p = glm::cross(ray.direction, triangle.ac);
  const double determinant = glm::dot(triangle.ab, p);
  determined = std::abs(determinant) > least_determinant(triangle);
  const double inverse = 1.0 / determinant;
  const Vec3 from_a = ray.origin - triangle.a;
  hit.u = glm::dot(from_a, p) * inverse;
  const Vec3 q = glm::cross(from_a, triangle.ab);
  hit.v = glm::dot(ray.direction, q) * inverse;
  hit.t = glm::dot(triangle.ac, q) * inverse;
  return hit.u >= 0 && hit.u <= 1 && hit.v >= 0 && hit.u + hit.v <= 1;
}

}  // namespace

bool crosses_exactly(const Corners& corners, const Ray& ray, TriangleHit& hit) {
  const Crossing crossing(corners, ray);
  if (!crossing.is_ahead() || !crossing.is_within_edges()) return false;
  hit = crossing.hit();
  return hit.t > ray.least_t;
}

Meeting meets_after_all(const Corners& corners, const Ray& ray, TriangleHit& hit) {
  const Crossing crossing(corners, ray);
  if (!crossing.is_ahead()) return Meeting::none;
  bool determined;
  const bool as_in_the_course = course_meets(Triangle(corners), ray, hit, determined);
  // Outside by less than the course's rounding tells is inside for it.
  if (!crossing.is_within_edges() && !(as_in_the_course && determined)) return Meeting::none;
  if (!(as_in_the_course && determined)) hit = crossing.hit();
  if (!(hit.t > ray.least_t)) return Meeting::none;
  if (as_in_the_course) return Meeting::hit;
  return crossing.is_on_edge() ? Meeting::edge_gap : Meeting::gap;
}

}  // namespace trace
