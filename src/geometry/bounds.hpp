// Axis-aligned boxes.
#pragma once

#include <limits>

#include "geometry/ray.hpp"

namespace trace {

struct Bounds {
  Vec3 min{std::numeric_limits<double>::infinity()};
  Vec3 max{-std::numeric_limits<double>::infinity()};

  bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }

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

// The box of the eight corners of `b` under `m`.
Bounds transformed(const Bounds& b, const Mat4& m);

// The language's own test before an object is intersected: slabs without tolerance, an axis along which the
// ray does not move is passed over. It decides silhouette pixels, so it is not replaced by a safer one.
bool hits_bounds(const Bounds& b, const Ray& ray);

}  // namespace trace
