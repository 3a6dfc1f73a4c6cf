// The square for packets; see shapes-inl.hpp.
#if defined(TRACE_GEOMETRY_PACKET_SQUARE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_GEOMETRY_PACKET_SQUARE_INL_HPP
#undef TRACE_GEOMETRY_PACKET_SQUARE_INL_HPP
#else
#define TRACE_GEOMETRY_PACKET_SQUARE_INL_HPP
#endif

#include "geometry/packet/rays-inl.hpp"
#include "geometry/square.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

HWY_INLINE Mask intersect(const Square&, const Rays& rays, const Mask& active, LocalHits& hits, Mask&) {
  const Mask asked = without(active, (rays.direction.z == 0.0) | (abs(rays.origin.z) <= rays.origin_error));
  hits.t = -rays.origin.z / rays.direction.z;
  const Vectors p = rays.at(hits.t);
  const Numbers z = select(rays.direction.z > 0.0, -1.0, 1.0);
  hits.normal = {0.0, 0.0, z};
  hits.u = p.x + 0.5;
  hits.v = p.y + 0.5;
  hits.part = 0.0;
  return asked & (hits.t > rays.least_t) & (p.x >= -0.5) & (p.x <= 0.5) & (p.y >= -0.5) & (p.y <= 0.5);
}

HWY_INLINE Numbers distance(const Square&, const Vectors& p, const Vectors&) {
  return abs(p.z) + gamma(4);
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
