// Ray against box as textbooks have it, to be compared with.
#pragma once

#include <algorithm>
#include <limits>

#include "geometry/bounds.hpp"

namespace trace::hard {

// Kay and Kajiya's slabs (1986) by std::min and std::max of the two distances of each axis: 0 * inf = NaN, of
// a ray in the plane of a face, is taken or left by the order of the arguments.
inline bool std_slabs(const Bounds& b, const Ray& ray) {
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = 1 / ray.direction[axis];
    const double t1 = (b.min[axis] - ray.origin[axis]) * inverse,
                 t2 = (b.max[axis] - ray.origin[axis]) * inverse;
    enter = std::max(enter, std::min(t1, t2));
    leave = std::min(leave, std::max(t1, t2));
  }
  return enter <= leave;
}

// The same in whole vectors.
inline bool glm_slabs(const Bounds& b, const Ray& ray) {
  const Vec3 inverse = 1.0 / ray.direction;
  const Vec3 t1 = (b.min - ray.origin) * inverse, t2 = (b.max - ray.origin) * inverse;
  const Vec3 near = glm::min(t1, t2), far = glm::max(t1, t2);
  const double enter = glm::max(glm::max(near.x, near.y), glm::max(near.z, 0.0));
  const double leave = glm::min(glm::min(far.x, far.y), far.z);
  return enter <= leave;
}

}  // namespace trace::hard
