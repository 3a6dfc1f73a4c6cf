// The unit cube in any kind of number, by slabs; geometry/box.hpp has the contract.
#pragma once

#include "geometry/box.hpp"
#include "precision/ray.hpp"

namespace trace::precision {

template <class T>
bool intersect(const Box&, const Ray<T>& ray, LocalHit<T>& hit) {
  T enter = -std::numeric_limits<T>::infinity(), leave = std::numeric_limits<T>::infinity();
  int in = 0, out = 0;  // faces in the order -x -y -z +x +y +z
  for (int axis = 0; axis < 3; ++axis) {
    const T o = ray.origin[axis], d = ray.direction[axis];
    if (d == 0) {
      if (std::abs(o) > T(0.5)) return false;
      continue;
    }
    const T near = d > 0 ? T(-0.5) : T(0.5);
    const T t_near = (near - o) / d, t_far = (-near - o) / d;
    if (t_near > enter) {
      enter = t_near;
      in = d > 0 ? axis : axis + 3;
    }
    if (t_far < leave) {
      leave = t_far;
      out = d > 0 ? axis + 3 : axis;
    }
  }
  if (!(enter <= leave)) return false;
  const bool from_outside = enter > ray.least_t;
  hit.t = from_outside ? enter : leave;
  if (!(hit.t > ray.least_t)) return false;
  const int face = from_outside ? in : out, axis = face % 3;
  const int low = axis == 0 ? 1 : 0, high = axis == 2 ? 1 : 2;
  const bool min_face = face < 3;
  const Vec3<T> p = ray.at(hit.t);
  hit.normal = Vec3<T>(0);
  hit.normal[axis] = min_face ? -1 : 1;
  hit.uv = Vec2<T>(min_face ? T(0.5) - p[low] : T(0.5) + p[low], T(0.5) + p[high]);
  return true;
}

template <class T>
T distance(const Box&, const Vec3<T>& p, const Vec3<T>& normal) {
  for (int axis = 0; axis < 3; ++axis) {
    if (normal[axis] != 0) return std::abs(p[axis] - T(0.5) * normal[axis]);
  }
  return 0;
}

}  // namespace trace::precision
