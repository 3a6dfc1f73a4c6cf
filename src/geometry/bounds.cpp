#include "geometry/bounds.hpp"

#include <utility>

namespace trace {

Bounds transformed(const Bounds& b, const Mat4& m) {
  if (b.unbounded()) return Bounds::everything();
  Bounds result;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec4 p(corner & 1 ? b.max.x : b.min.x, corner & 2 ? b.max.y : b.min.y,
                 corner & 4 ? b.max.z : b.min.z, 1);
    result.add(Vec3(m * p));
  }
  return result;
}

bool hits_bounds(const Bounds& b, const Ray& ray) {
  double enter = -std::numeric_limits<double>::infinity();
  double leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0) continue;
    double t1 = (b.min[axis] - ray.origin[axis]) / ray.direction[axis];
    double t2 = (b.max[axis] - ray.origin[axis]) / ray.direction[axis];
    if (t1 > t2) std::swap(t1, t2);
    if (t1 > enter) enter = t1;
    if (t2 < leave) leave = t2;
    if (enter > leave || leave < 0) return false;
  }
  return true;
}

}  // namespace trace
