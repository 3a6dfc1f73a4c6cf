// The sphere for packets; see shapes-inl.hpp.
#if defined(TRACE_GEOMETRY_PACKET_SPHERE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_GEOMETRY_PACKET_SPHERE_INL_HPP
#undef TRACE_GEOMETRY_PACKET_SPHERE_INL_HPP
#else
#define TRACE_GEOMETRY_PACKET_SPHERE_INL_HPP
#endif

#include "geometry/packet/quadratic-inl.hpp"
#include "geometry/sphere.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

HWY_INLINE Mask intersect(const Sphere&, const Rays& given, Mask active, LocalHits& hits, Mask&) {
  const Rays rays{given.origin, normalized(given.direction), given.origin_error, given.least_t};
  const Vectors to_centre = -rays.origin;
  const Numbers b = dot(to_centre, rays.direction);
  const Numbers square = dot(to_centre, to_centre);
  const Numbers discriminant = b * b - square + 1.0;
  const Numbers c = square - 1.0;
  const Mask good = is_well_conditioned(discriminant, b * b + square + 1.0);
  active = without(active, good & (discriminant < 0.0));
  if (none(active)) return active;
  const Numbers root = sqrt(discriminant);
  ManyRoots roots{b - root, b + root};
  if (const Mask asked = without(active, good); any(asked)) {
    const Vectors moment = accurate_cross(rays.origin, rays.direction);
    const Numbers a = dot(rays.direction, rays.direction), moment2 = dot(moment, moment);
    const Numbers value = a - moment2;
    const Mask decided = is_decided(value, a + moment2);
    const Mask missed = (decided & (value < 0.0)) | without(without(asked, decided), discriminant >= 0.0);
    active = without(active, asked & missed);
    roots = select(asked & decided, stable_roots(a, -b, c, sqrt(value)), roots);
  }
  const Numbers unsure = 4.0 * rays.origin_error + 2 * gamma(4);
  const Mask outside = c > unsure;
  const Mask on_surface = without(c >= -unsure, outside);
  active = without(active, without(outside, b > 0.0));
  active = without(active, without(on_surface, leave_inward(b, unsure, roots.second)));
  hits.t = select(outside, roots.first, roots.second);
  active &= hits.t > rays.least_t;
  hits.normal = normalized(rays.at(hits.t));
  hits.u = hits.v = hits.part = 0.0;
  return active;
}

HWY_INLINE Numbers distance(const Sphere&, const Vectors& p, const Vectors&) {
  return abs(sqrt(dot(p, p)) - 1.0) + gamma(4);
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
