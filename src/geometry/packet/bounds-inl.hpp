// The test of the language before an object is intersected, for packets.
#if defined(TRACE_GEOMETRY_PACKET_BOUNDS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_GEOMETRY_PACKET_BOUNDS_INL_HPP
#undef TRACE_GEOMETRY_PACKET_BOUNDS_INL_HPP
#else
#define TRACE_GEOMETRY_PACKET_BOUNDS_INL_HPP
#endif

#include <limits>

#include "geometry/bounds.hpp"
#include "geometry/packet/rays-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

// hits_bounds() of geometry/bounds.hpp, in its own quotients.
HWY_MAYBE_UNUSED static HWY_NOINLINE Mask hit_bounds_exactly(const Bounds& b, const Rays& rays,
                                                             const Mask& active) {
  Numbers enter = -std::numeric_limits<double>::infinity(), leave = std::numeric_limits<double>::infinity();
  const Numbers* const origin[3] = {&rays.origin.x, &rays.origin.y, &rays.origin.z};
  const Numbers* const direction[3] = {&rays.direction.x, &rays.direction.y, &rays.direction.z};
  for (int axis = 0; axis < 3; ++axis) {
    const Numbers o = *origin[axis], d = *direction[axis];
    const Mask moves = !(d == 0.0);
    const Numbers t1 = (b.min[axis] - o) / d, t2 = (b.max[axis] - o) / d;
    const Mask swapped = t1 > t2;
    const Numbers near = select(swapped, t2, t1), far = select(swapped, t1, t2);
    enter = select(moves & (near > enter), near, enter);
    leave = select(moves & (far < leave), far, leave);
  }
  return without(active, (enter > leave) | (leave < 0.0));
}

// One over the directions of rays, for many boxes.
struct Reciprocals {
  Vectors of;
  Mask finite;  // which have none that is infinite

  HWY_INLINE explicit Reciprocals(const Rays& rays)
      : of(1.0 / rays.direction.x, 1.0 / rays.direction.y, 1.0 / rays.direction.z), finite(all_finite(of)) {}
};

// hits_bounds() of geometry/bounds.hpp by products.
HWY_INLINE Mask hit_bounds(const Bounds& b, const Rays& rays, const Reciprocals& inverse,
                           const Mask& active) {
  const Numbers x1 = (b.min.x - rays.origin.x) * inverse.of.x, x2 = (b.max.x - rays.origin.x) * inverse.of.x;
  const Numbers y1 = (b.min.y - rays.origin.y) * inverse.of.y, y2 = (b.max.y - rays.origin.y) * inverse.of.y;
  const Numbers z1 = (b.min.z - rays.origin.z) * inverse.of.z, z2 = (b.max.z - rays.origin.z) * inverse.of.z;
  const Numbers enter = greatest(least(x1, x2), greatest(least(y1, y2), least(z1, z2)));
  const Numbers leave = least(greatest(x1, x2), least(greatest(y1, y2), greatest(z1, z2)));
  const Numbers slack = gamma(8) * (abs(enter) + abs(leave)) + std::numeric_limits<double>::min();
  const Numbers inside = leave - enter;
  const Mask certain = active & inverse.finite & (abs(inside) > slack);
  const Mask hit = certain & (least(inside, leave) >= 0.0);
  const Mask open = without(active, certain);
  return none(open) ? hit : hit | hit_bounds_exactly(b, rays, open);
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
