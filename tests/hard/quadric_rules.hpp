// The language's rules for cylinders and cones (docs/language.md section 5), written once for any kind of
// number: in 113 digits they are the truth, in double they are the textbook's quadratic.
#pragma once

#include <optional>

#include "tests/hard/quad.hpp"

namespace trace::hard {

inline double square_root(double x) {
  return std::sqrt(x);
}
inline Quad square_root(Quad x) {
  return root(x);
}

// `least`: hits up to here do not count.
template <class Number, class AnyRay>
std::optional<Number> cylinder_by_the_rules(const AnyRay& ray, Number least) {
  const auto &o = ray.origin, &d = ray.direction;
  std::optional<Number> side, cap;
  const Number a = d.x * d.x + d.y * d.y;
  const Number b = 2 * (o.x * d.x + o.y * d.y);
  const Number c = o.x * o.x + o.y * o.y - 1;
  const Number discriminant = b * b - 4 * a * c;
  if (a != 0 && discriminant >= 0) {
    const Number w = square_root(discriminant);
    for (const Number t : {(-b - w) / (2 * a), (-b + w) / (2 * a)}) {
      const Number z = o.z + t * d.z;
      if (!side && t > least && z >= 0 && z <= 1) side = t;
    }
  }
  if (d.z != 0) {
    const Number bottom = -o.z / d.z, top = (1 - o.z) / d.z;
    for (const Number t : {d.z > 0 ? bottom : top, d.z > 0 ? top : bottom}) {
      const Number x = o.x + t * d.x, y = o.y + t * d.y;
      if (!cap && t >= least && x * x + y * y <= 1) cap = t;
    }
  }
  return side && (!cap || *side < *cap) ? side : cap;
}

// A cone's side x^2 + y^2 = slope^2 (z + apex)^2 and its ends.
template <class Number>
struct ConeShape {
  Number bottom, top, height, slope, apex;
  bool capped;

  // Radii of at least 1e-4.
  ConeShape(double bottom_radius, double top_radius, double of_height, bool has_caps)
      : bottom(bottom_radius),
        top(top_radius),
        height(of_height),
        slope((top - bottom) / height),
        capped(has_caps) {
    if (slope < Number(1e-3) && slope > -Number(1e-3)) slope = Number(1e-3);
    apex = (slope < 0 ? top : bottom) / slope;
    if (apex < 0) apex -= height;
  }
};

template <class Number, class AnyRay>
std::optional<Number> cone_by_the_rules(const ConeShape<Number>& cone, const AnyRay& ray, Number least) {
  const auto &o = ray.origin, &d = ray.direction;
  const Number slope2 = cone.slope * cone.slope, above = o.z + cone.apex;
  const Number a = d.x * d.x + d.y * d.y - slope2 * d.z * d.z;
  if (a == 0) return std::nullopt;
  const Number b = 2 * (o.x * d.x + o.y * d.y - slope2 * above * d.z);
  const Number c = o.x * o.x + o.y * o.y - slope2 * above * above;
  const Number discriminant = b * b - 4 * a * c;
  if (!(discriminant > 0)) return std::nullopt;
  const Number w = square_root(discriminant);
  const Number r1 = (-b + w) / (2 * a), r2 = (-b - w) / (2 * a);
  const auto good = [&](Number t) {
    const Number z = o.z + t * d.z;
    return z >= 0 && z <= cone.height;
  };
  Number t = least;
  if (good(r1) && r1 > t) t = r1;
  if (good(r2) && ((good(r1) && r2 < t) || r2 > least)) t = r2;
  if (cone.capped && d.z != 0) {
    const auto try_cap = [&](Number z, Number radius) {
      const Number at = (z - o.z) / d.z;
      const Number x = o.x + at * d.x, y = o.y + at * d.y;
      if (at > least && at < t && x * x + y * y <= radius * radius) t = at;
    };
    try_cap(0, cone.bottom);
    try_cap(cone.height, cone.top);
  }
  if (!(t > least)) return std::nullopt;
  return t;
}

}  // namespace trace::hard
