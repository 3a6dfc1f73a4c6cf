#include "tests/hard/torus_truth.hpp"

#include <array>
#include <complex>
#include <vector>

namespace trace::hard {
namespace {

// From the constant on.
using Polynomial = std::vector<Quad>;

Quad value(const Polynomial& p, Quad t) {
  Quad sum = 0;
  for (auto c = p.rbegin(); c != p.rend(); ++c) sum = sum * t + *c;
  return sum;
}

Polynomial derivative(const Polynomial& p) {
  Polynomial result;
  for (std::size_t i = 1; i < p.size(); ++i) result.push_back(Quad(static_cast<double>(i)) * p[i]);
  return result;
}

// Where p, monotonic between the two, changes its sign. 16 halvings, then Newton's steps where they stay
// between, with a halving after each that does not.
Quad crossing(const Polynomial& p, const Polynomial& slope, Quad low, Quad high) {
  const bool rises = value(p, high) > 0;
  Quad t = (low + high) / 2;
  for (int step = 0; step < 250; ++step) {
    const Quad at = value(p, t);
    if (at == 0) return t;
    ((at > 0) == rises ? high : low) = t;
    const Quad newton = t - at / value(slope, t), middle = (low + high) / 2;
    const bool good = step > 16 && newton > low && newton < high;
    const Quad next = good ? newton : middle;
    if (magnitude(next - t) <= Quad(0x1p-108) * (magnitude(t) + Quad(0x1p-60))) return next;
    t = next;
  }
  return t;
}

// The sign changes between the two, ascending.
std::vector<Quad> crossings(const Polynomial& p, Quad low, Quad high) {
  std::vector<Quad> result;
  if (p.size() < 2) return result;
  const Polynomial slope = derivative(p);
  std::vector<Quad> ends = crossings(slope, low, high);
  ends.insert(ends.begin(), low);
  ends.push_back(high);
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if ((value(p, ends[i - 1]) > 0) == (value(p, ends[i]) > 0)) continue;
    result.push_back(crossing(p, slope, ends[i - 1], ends[i]));
  }
  return result;
}

}  // namespace

Quad height_above(const RingShape& shape, const QuadVec& p) {
  const Quad beyond = root(p.x * p.x + p.y * p.y) - Quad(shape.major);
  return root(beyond * beyond + p.z * p.z) - Quad(shape.minor);
}

std::optional<Quad> true_torus(const RingShape& shape, const QuadRay& ray) {
  const QuadVec& d = ray.direction;
  const Quad square = dot(d, d), nearest = -dot(ray.origin, d) / square;
  const QuadVec c = ray.at(nearest);
  const Quad major(shape.major), minor(shape.minor), four = 4 * major * major;
  const Quad reach = 2 * (major + minor);
  if (dot(c, c) > reach * reach) return std::nullopt;
  const Quad w = dot(c, c) + major * major - minor * minor, m = 2 * dot(c, d);
  const Polynomial g{w * w - four * (c.x * c.x + c.y * c.y), 2 * m * w - 2 * four * (c.x * d.x + c.y * d.y),
                     m * m + 2 * square * w - four * (d.x * d.x + d.y * d.y), 2 * m * square,
                     square * square};
  for (const Quad t : crossings(g, -reach, reach)) {
    if (!(nearest + t > 0)) continue;
    // Of a spindle torus the quartic also has the lemon inside.
    if (magnitude(height_above(shape, c + t * d)) > Quad(1e-20) * reach) continue;
    return nearest + t;
  }
  return std::nullopt;
}

std::optional<double> textbook_torus(const RingShape& shape, const Ray& ray) {
  using Complex = std::complex<double>;
  const Vec3 &o = ray.origin, &d = ray.direction;
  const double along = glm::dot(o, d), four = 4 * shape.major * shape.major;
  const double k = glm::dot(o, o) + shape.major * shape.major - shape.minor * shape.minor;
  const double b = 4 * along;
  const double c = 2 * k + 4 * along * along - four * (d.x * d.x + d.y * d.y);
  const double e = 4 * k * along - 2 * four * (o.x * d.x + o.y * d.y);
  const double f = k * k - four * (o.x * o.x + o.y * o.y);
  // y^4 + p y^2 + q y + r with t = y - b / 4, and its resolvent m^3 + p m^2 + (p^2 / 4 - r) m - q^2 / 8.
  const double p = c - 3 * b * b / 8, q = b * b * b / 8 - b * c / 2 + e;
  const double r = -3 * b * b * b * b / 256 + b * b * c / 16 - b * e / 4 + f;
  const double u = p * p / 4 - r, v = -q * q / 8;
  const double third = u - p * p / 3, rest = 2 * p * p * p / 27 - p * u / 3 + v;
  const Complex w =
      std::pow(-rest / 2 + std::sqrt(Complex(rest * rest / 4 + third * third * third / 27)), 1.0 / 3);
  const Complex m = (w == 0.0 ? Complex(0) : w - third / (3.0 * w)) - p / 3;
  const Complex s = std::sqrt(2.0 * m);
  std::optional<double> nearest;
  for (const double one : {1.0, -1.0}) {
    const Complex inside = std::sqrt(-(2 * p + 2.0 * m + one * 2 * q / s));
    for (const double other : {1.0, -1.0}) {
      const Complex t = (one * s + other * inside) / 2.0 - b / 4;
      if (!(std::abs(t.imag()) < 1e-8 && t.real() > 1e-8)) continue;
      if (!nearest || t.real() < *nearest) nearest = t.real();
    }
  }
  return nearest;
}

}  // namespace trace::hard
