// Axis-aligned boxes.
#pragma once

#include <limits>

#include "geometry/ray.hpp"
#include "geometry/rounding.hpp"

namespace trace {

struct Bounds {
  Vec3 min{std::numeric_limits<double>::infinity()};
  Vec3 max{-std::numeric_limits<double>::infinity()};

  bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }

  static Bounds everything() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {Vec3(-infinity), Vec3(infinity)};
  }
  // Whether it goes on for ever to any side.
  bool unbounded() const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return min.x == -infinity || min.y == -infinity || min.z == -infinity || max.x == infinity ||
           max.y == infinity || max.z == infinity;
  }

  void add(const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] < min[axis]) min[axis] = p[axis];
      if (p[axis] > max[axis]) max[axis] = p[axis];
    }
  }

  void add(const Bounds& b) {
    add(b.min);
    add(b.max);
  }
};

// The box of the eight corners of `b` under `m`; everything where `b` is unbounded.
Bounds transformed(const Bounds& b, const Mat4& m);

// The language's own test before an object is intersected: slabs without tolerance, an axis along which the
// ray does not move is passed over. It decides silhouette pixels, so it is not replaced by a safer one.
bool hits_bounds(const Bounds& b, const Ray& ray);

// One over the direction of a ray, for many boxes.
struct Reciprocal {
  Vec3 of;
  bool finite;

  explicit Reciprocal(const Ray& ray)
      : of(1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z),
        finite(std::isfinite(of.x + of.y + of.z)) {}
};

// hits_bounds() by products. A product with the reciprocal is off by three roundings from the quotient, which
// itself is off by one; its sign is that of the quotient, for directions are of unit length and so
// reciprocals at least one. Where that leaves open what comes first, the quotients themselves are asked.
inline bool hits_bounds(const Bounds& b, const Ray& ray, const Reciprocal& inverse) {
  const auto lesser = [](double p, double q) { return p < q ? p : q; };
  const auto greater = [](double p, double q) { return p > q ? p : q; };
  const Vec3 at_min = (b.min - ray.origin) * inverse.of, at_max = (b.max - ray.origin) * inverse.of;
  const double enter =
      greater(lesser(at_min.x, at_max.x), greater(lesser(at_min.y, at_max.y), lesser(at_min.z, at_max.z)));
  const double leave =
      lesser(greater(at_min.x, at_max.x), lesser(greater(at_min.y, at_max.y), greater(at_min.z, at_max.z)));
  const double slack = gamma(8) * (std::abs(enter) + std::abs(leave)) + std::numeric_limits<double>::min();
  const double inside = leave - enter;
  if (std::abs(inside) > slack && inverse.finite) return lesser(inside, leave) >= 0;
  return hits_bounds(b, ray);
}

}  // namespace trace
