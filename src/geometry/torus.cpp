#include "geometry/torus.hpp"

#include <algorithm>
#include <array>

#include "geometry/nearest_point.hpp"
#include "geometry/quadratic.hpp"
#include "geometry/texture_coordinates.hpp"

namespace trace {
namespace {

// Numbers in ascending order, a few.
struct Few {
  std::array<double, 6> at{};
  std::size_t count = 0;

  void add(double value) { at[count++] = value; }
};

// The zero of a function between `low` and `high`, where its signs differ; it and its derivative are told by
// f. Newton's steps, halving where one would leave what is known to enclose the zero or gains too little; a
// step of at most `enough` is the last.
template <class Function>
double zero_between(double low, double high, bool rises, double enough, const Function& f) {
  double t = low + 0.5 * (high - low), last = high - low;
  // Each step is at most half the one before, or halves what encloses the zero. Five or so are usual.
  for (int step = 0; step < 200; ++step) {
    const auto [value, slope] = f(t);
    if (value == 0) return t;
    ((value > 0) == rises ? high : low) = t;
    const double newton = t - value / slope, middle = low + 0.5 * (high - low);
    const bool good = newton > low && newton < high && std::abs(newton - t) <= 0.5 * last;
    const double next = good ? newton : middle;
    last = std::abs(next - t);
    if (last <= enough || (!good && (middle == low || middle == high))) return next;
    t = next;
  }
  return t;
}

// Sizes between about 1e-75 and 1e75, whose fourth powers are numbers.
struct Ring {
  double major, minor;

  double height(const Vec3& p) const {  // F
    const double beyond = std::sqrt(radius_squared(p)) - major;
    return std::sqrt(beyond * beyond + p.z * p.z) - minor;
  }
  Vec3 outward(const Vec3& p) const {  // the gradient of F
    const double radius = std::sqrt(radius_squared(p)), beyond = radius - major;
    const double from_circle = std::sqrt(beyond * beyond + p.z * p.z);
    if (from_circle == 0) return Vec3(0, 0, 1);
    const double across = radius == 0 ? 0 : beyond / radius;
    return Vec3(across * p.x, across * p.y, p.z) / from_circle;
  }
};

struct ValueAndSlope {
  double value, slope;
};

// The sign changes of a function beyond `from` in the pieces between `ends`, on each of which it has at most
// one. found(t, whether it rises) says whether to go on.
template <class Function, class Found>
void sign_changes(const Few& ends, double from, double enough, const Function& f, const Found& found) {
  bool was_above = f(ends.at[0]).value > 0;
  for (std::size_t i = 1; i < ends.count; ++i) {
    const bool is_above = f(ends.at[i]).value > 0;
    if (is_above != was_above && ends.at[i] > from) {
      if (!found(zero_between(ends.at[i - 1], ends.at[i], is_above, enough, f), is_above)) return;
    }
    was_above = is_above;
  }
}

// -limit, the zeros of t^3 + p t + q between, limit. Newton's last step squares what the zeros are off by,
// from 2^-30 of the limit.
Few zeros_of_cubic(double p, double q, double limit) {
  const auto cubic = [&](double t) { return ValueAndSlope{(t * t + p) * t + q, 3 * t * t + p}; };
  Few turns;
  turns.add(-limit);
  if (p < 0) {
    const double turn = std::sqrt(-p / 3);
    if (turn < limit) {
      turns.add(-turn);
      turns.add(turn);
    }
  }
  turns.add(limit);
  Few zeros;
  zeros.add(-limit);
  sign_changes(turns, -limit, 0x1p-30 * limit, cubic, [&](double t, bool) {
    zeros.add(t);
    return true;
  });
  zeros.add(limit);
  return zeros;
}

}  // namespace

Torus::Torus(double major, double minor)
    : major_(major), minor_(minor), unit_(std::ldexp(1.0, -std::ilogb(major + minor))) {}

bool Torus::intersect(const Ray& given, LocalHit& hit) const {
  const Ray ray{unit_ * given.origin, given.direction, unit_ * given.origin_error, unit_ * given.least_t};
  const Ring ring{unit_ * major_, unit_ * minor_};
  const Vec3& d = ray.direction;
  const NearestPoint nearest = nearest_point(ray);
  const Vec3& c = nearest.place;
  const double reach = ring.major + ring.minor, near = glm::dot(c, c);
  // A little more than where the line is within the sphere around it.
  const double limit_squared = reach * reach * (1 + 0x1p-40) - near;
  if (!(limit_squared > 0)) return false;

  const double major2 = ring.major * ring.major;
  const double k = near + (ring.major - ring.minor) * reach;
  const double a = d.x * d.x + d.y * d.y, b = c.x * d.x + c.y * d.y;
  const Few pieces = zeros_of_cubic(k - 2 * major2 * a, -2 * major2 * b, std::sqrt(limit_squared));

  // A ray that starts on the surface, as far as its origin is known, does not meet it there: what it can meet
  // is the next crossing the other way. Of one that runs along the surface the crossing decides, as the
  // sphere's (leaves_inward()). F changes no faster than its place, which is off by less than sqrt(3) of the
  // origin's error; the normal turns by that over the tube's radius.
  const double unsure = 2 * ray.origin_error + gamma(8) * (largest(ray.origin) + reach);
  const bool on_surface = std::abs(ring.height(ray.origin)) <= unsure;
  const double rising = glm::dot(ring.outward(ray.origin), d);
  const bool along = std::abs(rising) <= 2 * unsure / ring.minor + gamma(8);
  const double least = on_surface && along ? std::max(ray.least_t, unit_ * course_least_t) : ray.least_t;

  bool found = false;
  sign_changes(
      pieces, least - nearest.t, 0,
      [&](double t) {
        const Vec3 p = c + t * d;
        return ValueAndSlope{ring.height(p), glm::dot(ring.outward(p), d)};
      },
      [&](double t, bool leaves) {
        const double at = nearest.t + t;
        if (!(at > least)) return true;
        if (on_surface && !along && leaves == (rising > 0)) return true;
        found = true;
        hit.t = at / unit_;
        hit.normal = glm::normalize(ring.outward(c + t * d));
        return false;
      });
  return found;
}

double Torus::distance(const Vec3& p, const Vec3&) const {
  return std::abs(Ring{unit_ * major_, unit_ * minor_}.height(unit_ * p)) / unit_ +
         gamma(4) * (major_ + minor_);
}

Vec2 Torus::texture_coordinates(const Vec3& p, const Vec3&) const {
  return {turn_around(p.x, p.y), turn_around(std::sqrt(radius_squared(p)) - major_, p.z)};
}

}  // namespace trace
