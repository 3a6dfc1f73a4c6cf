#include "geometry/quadric.hpp"

#include <algorithm>
#include <utility>

#include "geometry/double_double.hpp"
#include "geometry/quadratic.hpp"
#include "geometry/texture_coordinates.hpp"

namespace trace {
namespace {

// q at a place, half its gradient there, and along a direction the coefficients of a t^2 + 2 h t + c. Written
// once for doubles and for numbers of twice the digits.
template <class N>
struct Three {
  N x, y, z;
};

template <class N>
N dot(const Three<N>& a, const Three<N>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class N>
struct Equation {
  N squares[3], mixed[3], linear[3], constant;  // halves of the mixed and linear ones: xy, xz, yz

  explicit Equation(const Quadric::Coefficients& q)
      : squares{N{q[0]}, N{q[1]}, N{q[2]}},
        mixed{N{0.5 * q[3]}, N{0.5 * q[4]}, N{0.5 * q[5]}},
        linear{N{0.5 * q[6]}, N{0.5 * q[7]}, N{0.5 * q[8]}},
        constant{q[9]} {}

  Three<N> times(const Three<N>& p) const {
    return {squares[0] * p.x + mixed[0] * p.y + mixed[1] * p.z,
            mixed[0] * p.x + squares[1] * p.y + mixed[2] * p.z,
            mixed[1] * p.x + mixed[2] * p.y + squares[2] * p.z};
  }
  Three<N> half_gradient(const Three<N>& p) const {
    const Three<N> m = times(p);
    return {m.x + linear[0], m.y + linear[1], m.z + linear[2]};
  }
  N value(const Three<N>& p) const {
    const Three<N> m = times(p), g{linear[0] + linear[0], linear[1] + linear[1], linear[2] + linear[2]};
    return dot(p, Three<N>{m.x + g.x, m.y + g.y, m.z + g.z}) + constant;
  }
};

template <class N>
struct Line {
  N a, h, c;

  Line(const Equation<N>& q, const Three<N>& origin, const Three<N>& direction)
      : a(dot(direction, q.times(direction))),
        h(dot(direction, q.half_gradient(origin))),
        c(q.value(origin)) {}

  N discriminant() const { return h * h - a * c; }
};

template <class N>
Three<N> three(const Vec3& v) {
  return {N{v.x}, N{v.y}, N{v.z}};
}

Vec3 vector(const Three<double>& v) {
  return {v.x, v.y, v.z};
}

// The same equation and places without signs: what roundings are relative to.
Quadric::Coefficients sizes(Quadric::Coefficients q) {
  for (double& x : q) x = std::abs(x);
  return q;
}

// The largest second derivative, at least.
double curvature(const Equation<double>& size) {
  const Three<double> rows = size.times({1, 1, 1});
  return 2 * std::max({rows.x, rows.y, rows.z});
}

struct Meetings {
  double t[2];  // ascending; infinite or not a number where there is none
};

}  // namespace

// Divided by a power of two, so that squares of coefficients stay in range.
Quadric::Quadric(const Coefficients& coefficients, const Bounds& limits, const Bounds& extent) {
  Form form{coefficients, limits, extent};
  double most = 0;
  for (const double x : coefficients) most = std::max(most, std::abs(x));
  const int exponent = most > 0 ? std::ilogb(most) : 0;
  for (double& x : form.coefficients) x = std::ldexp(x, -exponent);
  form_ = std::make_shared<const Form>(form);
}

bool Quadric::intersect(const Ray& ray, LocalHit& hit) const {
  const Vec3 &o = ray.origin, &d = ray.direction;
  const Equation<double> q(form_->coefficients), size(sizes(form_->coefficients));
  const Line<double> line(q, three<double>(o), three<double>(d));
  const Line<double> terms(size, three<double>(glm::abs(o)), three<double>(glm::abs(d)));
  double a = line.a, h = line.h, c = line.c, discriminant = line.discriminant();
  const bool plain = Discriminant{discriminant, terms.h * terms.h + terms.a * terms.c}.is_well_conditioned();
  if (!plain) {
    const Line<DoubleDouble> exact(Equation<DoubleDouble>(form_->coefficients), three<DoubleDouble>(o),
                                   three<DoubleDouble>(d));
    a = exact.a.rounded();
    h = exact.h.rounded();
    c = exact.c.rounded();
    discriminant = exact.discriminant().rounded();
  }
  if (!(discriminant >= 0)) return false;
  const Roots roots = stable_roots(a, h, c, std::sqrt(discriminant));
  Meetings meetings{{roots.first, roots.second}};
  if (plain) {
    for (double& t : meetings.t) {
      const Three<double> p = three<double>(ray.at(t));
      const double step = 0.5 * q.value(p) / dot(q.half_gradient(p), three<double>(d));
      if (std::abs(step) <= 0x1p-20 * std::abs(t)) t -= step;
    }
  }
  // A ray that starts on the surface does so at t = 0. A step e in each coordinate changes q by e times the
  // gradient and e^2 times the squares.
  const Vec3 slope = 2.0 * vector(q.half_gradient(three<double>(o)));
  const double e = ray.origin_error;
  const double unsure = e * (sum_of_sizes(slope) + 1.5 * e * curvature(size)) + gamma(12) * terms.c;
  if (std::abs(c) <= unsure) {
    (std::abs(meetings.t[0]) < std::abs(meetings.t[1]) ? meetings.t[0] : meetings.t[1]) = 0;
  }
  if (meetings.t[1] < meetings.t[0]) std::swap(meetings.t[0], meetings.t[1]);
  const Bounds& limits = form_->limits;
  for (const double t : meetings.t) {
    if (!(t > ray.least_t && t < std::numeric_limits<double>::infinity())) continue;
    const Vec3 p = ray.at(t);
    if (!(p.x >= limits.min.x && p.x <= limits.max.x && p.y >= limits.min.y && p.y <= limits.max.y &&
          p.z >= limits.min.z && p.z <= limits.max.z)) {
      continue;
    }
    const Vec3 gradient = vector(q.half_gradient(three<double>(p)));
    hit.t = t;
    hit.normal = is_zero(gradient) ? -d : glm::normalize(gradient);
    if (glm::dot(hit.normal, d) > 0) hit.normal = -hit.normal;
    return true;
  }
  return false;
}

// With |q| <= e, a gradient g and second derivatives of at most l there is a zero within 2 e / g where 2 e l
// <= g^2 (Kantorovich's condition for Newton's steps along the gradient). Next to an apex or a line where
// sheets meet, q is about l / 2 times the square of the distance.
double Quadric::distance(const Vec3& p, const Vec3&) const {
  const Equation<double> q(form_->coefficients), size(sizes(form_->coefficients));
  const double e = std::abs(q.value(three<double>(p))) + gamma(12) * size.value(three<double>(glm::abs(p)));
  const double g = 2 * glm::length(vector(q.half_gradient(three<double>(p)))), l = curvature(size);
  if (e == 0) return 0;
  if (!(2 * e * l <= g * g)) return std::sqrt(2 * e / l);
  // The first step, lengthened by what the second derivative may take off the gradient over it.
  return e / g * (1 + e * l / (g * g));
}

Vec2 Quadric::texture_coordinates(const Vec3& p, const Vec3&) const {
  const Bounds& extent = form_->extent;
  if (extent.unbounded()) return by_direction(p);
  const Vec3 across = (p - extent.min) / (extent.max - extent.min);
  return {in_unit(across.x), in_unit(across.z)};
}

}  // namespace trace
