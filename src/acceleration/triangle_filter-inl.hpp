// The test of triangle_filter.hpp, side by side: one ray and the triangles of a leaf, or one triangle and the
// rays of a packet, with what there is one of in every lane.
#if defined(TRACE_ACCELERATION_TRIANGLE_FILTER_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_ACCELERATION_TRIANGLE_FILTER_INL_HPP
#undef TRACE_ACCELERATION_TRIANGLE_FILTER_INL_HPP
#else
#define TRACE_ACCELERATION_TRIANGLE_FILTER_INL_HPP
#endif

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Products may be fused with sums; the bounds allow for either.
template <class V>
HWY_INLINE V filter_dot(const V* a, const V* b) {
  return hn::MulAdd(a[2], b[2], hn::MulAdd(a[1], b[1], hn::Mul(a[0], b[0])));
}
template <class V>
HWY_INLINE void filter_cross(const V* a, const V* b, V* result) {
  for (int axis = 0; axis < 3; ++axis) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    result[axis] = hn::MulSub(a[i], b[j], hn::Mul(a[j], b[i]));
  }
}

// The lanes that are not rejected. Ray: FilterRay's origin, direction and reach, and furthest() of its limit;
// triangle: the runs of TriangleFilter.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> may_meet(D d, const V* origin, const V* direction, const V& reach, const V& furthest,
                                const V* corner, const V* ab, const V* ac, const V& size) {
  const V from_a[3] = {hn::Sub(origin[0], corner[0]), hn::Sub(origin[1], corner[1]),
                       hn::Sub(origin[2], corner[2])};
  const V bound = hn::Mul(hn::Mul(hn::Set(d, 64 * 0x1p-24f), size), hn::Add(reach, size));
  V p[3], q[3];
  filter_cross(direction, ac, p);
  filter_cross(from_a, ab, q);
  const V determinant = filter_dot(ab, p);
  const V sign = hn::And(determinant, hn::Set(d, -0.0f));
  const V whole = hn::Xor(determinant, sign);
  const V u = hn::Xor(filter_dot(from_a, p), sign), v = hn::Xor(filter_dot(direction, q), sign);
  const V t = hn::Xor(filter_dot(ac, q), sign);
  const V below = hn::Neg(bound), above = hn::Add(whole, bound);
  const auto beside = hn::Or(hn::Or(hn::Lt(u, below), hn::Lt(v, below)), hn::Gt(hn::Add(u, v), above));
  const auto before_or_beyond =
      hn::Or(hn::Lt(t, hn::Mul(below, size)), hn::Gt(t, hn::MulAdd(furthest, above, hn::Mul(bound, size))));
  return hn::Not(hn::And(hn::Gt(whole, bound), hn::Or(beside, before_or_beyond)));
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
