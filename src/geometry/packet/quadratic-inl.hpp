// Roots and discriminants of quadrics for packets: geometry/quadratic.hpp.
#if defined(TRACE_GEOMETRY_PACKET_QUADRATIC_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_GEOMETRY_PACKET_QUADRATIC_INL_HPP
#undef TRACE_GEOMETRY_PACKET_QUADRATIC_INL_HPP
#else
#define TRACE_GEOMETRY_PACKET_QUADRATIC_INL_HPP
#endif

#include "geometry/packet/rays-inl.hpp"
#include "geometry/quadratic.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

struct ManyRoots {
  Numbers first, second;
};

HWY_INLINE ManyRoots select(const Mask& m, const ManyRoots& yes, const ManyRoots& no) {
  return {select(m, yes.first, no.first), select(m, yes.second, no.second)};
}

HWY_INLINE Mask is_well_conditioned(const Numbers& discriminant, const Numbers& terms) {
  return abs(discriminant) > 0x1p-16 * terms;
}
HWY_INLINE Mask is_decided(const Numbers& discriminant, const Numbers& terms) {
  return abs(discriminant) > gamma(8) * terms;
}

HWY_INLINE ManyRoots stable_roots(const Numbers& a, const Numbers& h, const Numbers& c, const Numbers& root) {
  const Mask up = h > 0.0;
  const Numbers q = select(up, -(h + root), root - h);
  const Numbers q_by_a = q / a, c_by_q = c / q;
  return {select(up, q_by_a, c_by_q), select(up, c_by_q, q_by_a)};
}

HWY_INLINE Mask leave_inward(const Numbers& inward, const Numbers& unsure, const Numbers& far_t) {
  const Mask tangent = abs(inward) <= unsure;
  return (tangent & (far_t > course_least_t)) | without(inward > 0.0, tangent);
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
