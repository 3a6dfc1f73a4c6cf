#include <algorithm>

#include "geometry/double_double.hpp"
#include "geometry/expansion.hpp"
#include "geometry/rounding.hpp"
#include "geometry/triangle.hpp"

namespace trace {
namespace {

template <class Number>
struct Vector {
  Number x, y, z;
};

template <class Number>
Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector<DoubleDouble> difference(const Vec3& a, const Vec3& b) {
  return {exact_sum(a.x, -b.x), exact_sum(a.y, -b.y), exact_sum(a.z, -b.z)};
}

Expansion exact(const DoubleDouble& a) {
  return Expansion(a.low) + Expansion(a.high);
}

Vector<Expansion> exact(const Vector<DoubleDouble>& a) {
  return {exact(a.x), exact(a.y), exact(a.z)};
}

double largest_coordinate(const Vector<DoubleDouble>& a) {
  return largest(Vec3(a.x.high, a.y.high, a.z.high));
}

// Six times a signed volume: rounded, and its sign, which is exact.
struct Volume {
  double value;
  int sign;

  // `value`, off by at most `bound`, has the sign unless it is too small; then `exactly()` tells.
  template <class Exactly>
  Volume(const DoubleDouble& estimate, double bound, Exactly&& exactly)
      : value(estimate.rounded()), sign(value > 0 ? 1 : -1) {
    if (std::abs(value) > bound) return;
    const Expansion expansion = exactly();
    value = expansion.estimate();
    sign = expansion.sign();
  }
};

// A power of two that brings the coordinates near one, so that products neither overflow nor underflow.
double scale_of(const Corners& corners, const Vec3& origin) {
  const double size = std::max({largest(corners.a), largest(corners.b), largest(corners.c), largest(origin)});
  if (size == 0) return 1;
  return std::ldexp(1.0, std::clamp(-std::ilogb(size), -1022, 1022));
}

// The corners as seen from the origin of a ray, scaled.
struct Seen {
  Vector<DoubleDouble> a, b, c, d;
  double bound;  // on the error of a volume below

  Seen(const Corners& corners, const Ray& ray, double scale) {
    const Vec3 origin = scale * ray.origin;
    a = difference(scale * corners.a, origin);
    b = difference(scale * corners.b, origin);
    c = difference(scale * corners.c, origin);
    d = {{ray.direction.x, 0}, {ray.direction.y, 0}, {ray.direction.z, 0}};
    // Six products of three numbers each, no larger than these, and less than 32 operations of 2^-100 on each
    // way through. Three such volumes are summed, and a volume may be of three corners instead of two.
    const double size = std::max({largest_coordinate(a), largest_coordinate(b), largest_coordinate(c)});
    bound = 3 * 6 * 32 * 0x1p-100 * size * size * std::max(size, 1.0);
  }

  // Of the direction and the edge from p to q.
  template <Vector<DoubleDouble> Seen::*p, Vector<DoubleDouble> Seen::*q>
  Volume edge() const {
    return {dot(d, cross(this->*p, this->*q)), bound,
            [&] { return dot(exact(d), cross(exact(this->*p), exact(this->*q))); }};
  }
  // Of the direction and the whole triangle: the sum of the three of its edges.
  Volume whole() const {
    return {dot(d, cross(b, c)) + dot(d, cross(c, a)) + dot(d, cross(a, b)), bound, [&] {
              const Vector<Expansion> ea = exact(a), eb = exact(b), ec = exact(c), ed = exact(d);
              return dot(ed, cross(eb, ec)) + dot(ed, cross(ec, ea)) + dot(ed, cross(ea, eb));
            }};
  }
  // Of the three corners: t times that of the whole.
  Volume height() const {
    return {dot(a, cross(b, c)), bound, [&] { return dot(exact(a), cross(exact(b), exact(c))); }};
  }
};

class Crossing {
 public:
  Crossing(const Corners& corners, const Ray& ray) : Crossing(corners, ray, scale_of(corners, ray.origin)) {}

  // Whether the plane of the triangle is ahead of the origin, and the origin not in it as far as is known.
  bool is_ahead() const {
    if (whole_.sign == 0 || height_.sign != whole_.sign) return false;
    if (ray_.origin_error == 0) return true;
    const Vec3 normal =
        accurate_cross(scale_ * corners_.b - scale_ * corners_.a, scale_ * corners_.c - scale_ * corners_.a);
    return std::abs(height_.value) > sum_of_sizes(normal) * (scale_ * ray_.origin_error);
  }

  bool is_within_edges() const {
    const int beyond = -whole_.sign;
    return u_.sign != beyond && v_.sign != beyond && w_.sign != beyond;
  }
  bool is_on_edge() const { return u_.sign == 0 || v_.sign == 0 || w_.sign == 0; }

  TriangleHit hit() const {
    const double u = std::clamp(u_.value / whole_.value, 0.0, 1.0);
    return {height_.value / whole_.value / scale_, u, std::clamp(v_.value / whole_.value, 0.0, 1.0 - u)};
  }

 private:
  Crossing(const Corners& corners, const Ray& ray, double scale)
      : Crossing(corners, ray, scale, Seen(corners, ray, scale)) {}
  Crossing(const Corners& corners, const Ray& ray, double scale, const Seen& seen)
      : corners_(corners),
        ray_(ray),
        scale_(scale),
        u_(seen.edge<&Seen::c, &Seen::a>()),
        v_(seen.edge<&Seen::a, &Seen::b>()),
        w_(seen.edge<&Seen::b, &Seen::c>()),
        whole_(seen.whole()),
        height_(seen.height()) {}

  const Corners& corners_;
  const Ray& ray_;
  double scale_;
  Volume u_, v_, w_, whole_, height_;
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
