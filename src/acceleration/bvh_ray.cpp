#include "acceleration/bvh.hpp"

namespace trace {

BvhRay::BvhRay(const Bvh& bvh, const Ray& ray) {
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis];
    const auto origin = static_cast<float>(ray.origin[axis] - bvh.centre[axis]);
    const float error =
        0x1p-22f * std::abs(origin) + static_cast<float>(0x1p-44 * std::abs(bvh.centre[axis]));
    const auto inverse = static_cast<float>(1.0 / d);
    negative[axis] = std::signbit(d);
    near_origin[axis] = negative[axis] ? origin - error : origin + error;
    far_origin[axis] = negative[axis] ? origin + error : origin - error;
    near_inverse[axis] = inverse * (1 - 0x1p-21f);
    far_inverse[axis] = inverse * (1 + 0x1p-21f);
  }
}

}  // namespace trace
