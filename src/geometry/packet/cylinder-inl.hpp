// The cylinder for packets; see shapes-inl.hpp. Only what Cylinder::intersect_across_rim() finds is unusual.
#if defined(TRACE_GEOMETRY_PACKET_CYLINDER_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_GEOMETRY_PACKET_CYLINDER_INL_HPP
#undef TRACE_GEOMETRY_PACKET_CYLINDER_INL_HPP
#else
#define TRACE_GEOMETRY_PACKET_CYLINDER_INL_HPP
#endif

#include <limits>

#include "geometry/cylinder.hpp"
#include "geometry/packet/quadratic-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

// Where the lines of rays meet the endless cylinder; `a` and `c` are the coefficients of the equation, and
// `along` half of the third.
HWY_INLINE Mask meet_endless_cylinder(const Rays& rays, const Numbers& a, const Numbers& along,
                                      const Numbers& c, const Mask& asked, ManyRoots& roots) {
  const Vectors &o = rays.origin, &d = rays.direction;
  const Numbers b = 2.0 * along;
  const Numbers discriminant = b * b - 4.0 * a * c;
  const Mask good = is_well_conditioned(discriminant, b * b + 4.0 * a * (c + 2.0));
  const Numbers root = sqrt(discriminant);
  roots = {(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)};
  Mask meet = discriminant >= 0.0;
  if (any(without(asked, good))) {
    const Numbers moment = difference_of_products(o.x, d.y, o.y, d.x);
    const Numbers value = a - moment * moment;
    const Mask decided = without(is_decided(value, a + moment * moment), good);
    roots = select(decided, stable_roots(a, 0.5 * b, c, sqrt(value)), roots);
    meet = without(meet, decided) | without(decided, value < 0.0);
  }
  return asked & meet;
}

// Where a ray meets the planes of the caps.
struct CapPlanes {
  Numbers bottom, top;
};

// Cylinder::intersect_across_rim(): the lanes in which it finds something. `sides` are those with roots.
HWY_INLINE Mask cross_rim(const Rays& rays, const Mask& asked, const Mask& leaves, const Numbers& a,
                          const Numbers& c, const Numbers& unsure, const Mask& sides, const ManyRoots& roots,
                          const CapPlanes& planes) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const Numbers &oz = rays.origin.z, &dz = rays.direction.z;
  const Mask upright = a == 0.0, level = dz == 0.0;
  const ManyRoots side = select(upright, ManyRoots{-inf, inf}, roots);
  const ManyRoots caps =
      select(level, ManyRoots{-inf, inf},
             ManyRoots{lesser_of(planes.bottom, planes.top), greater_of(planes.bottom, planes.top)});
  const Mask beside = select(upright, c > 0.0, !sides) | (level & ((oz < 0.0) | (oz > 1.0)));
  const Numbers enter = greater_of(side.first, caps.first), leave = lesser_of(side.second, caps.second);
  const Mask crosses = without(asked, beside) & (leave - enter > 0x1p-30 * (abs(enter) + abs(leave)));
  if (none(crosses)) return crosses;
  const Mask upward = dz > 0.0;
  const Mask on_side = abs(c) <= unsure;
  const Mask on_bottom = abs(oz) <= rays.origin_error, on_top = abs(oz - 1.0) <= rays.origin_error;
  const Mask stuck_at_enter = select(caps.first > side.first, select(upward, on_bottom, on_top), on_side);
  const Mask stuck_at_leave = select(caps.second < side.second, select(upward, on_top, on_bottom), on_side);
  return crosses & (without(enter > rays.least_t, stuck_at_enter) |
                    without(leave > rays.least_t, stuck_at_leave | leaves));
}

HWY_INLINE Mask intersect(const Cylinder&, const Rays& rays, const Mask& active, LocalHits& hits,
                          Mask& unusual) {
  const Vectors &o = rays.origin, &d = rays.direction;
  const Numbers a = d.x * d.x + d.y * d.y, along = o.x * d.x + o.y * d.y;
  const Numbers c = o.x * o.x + o.y * o.y - 1.0;  // positive outside
  const Numbers unsure = 4.0 * rays.origin_error + 2 * gamma(4);
  ManyRoots roots;
  const Mask sides = meet_endless_cylinder(rays, a, along, c, without(active, a == 0.0), roots);

  const auto within = [&](const Numbers& t) HWY_ATTR {
    const Numbers z = o.z + t * d.z;
    return (t > rays.least_t) & (z >= 0.0) & (z <= 1.0);
  };
  const Mask outside = c > unsure;
  const Mask comes_in = sides & outside & (along < 0.0);
  const Mask goes_out =
      without(sides & ((c < -unsure) | leave_inward(-along, unsure, roots.second)), outside);
  const Mask by_first = comes_in & within(roots.first);
  const Mask on_side = by_first | ((comes_in | goes_out) & within(roots.second));
  const Numbers side_t = select(by_first, roots.first, roots.second);

  const CapPlanes planes{-o.z / d.z, (1.0 - o.z) / d.z};
  const Mask upward = d.z > 0.0;
  const auto on_disk = [&](const Numbers& t, const Numbers& above) HWY_ATTR {
    const Numbers x = o.x + t * d.x, y = o.y + t * d.y;
    return without((t > rays.least_t) & (x * x + y * y <= 1.0), abs(above) <= rays.origin_error);
  };
  const Mask slanted = without(active, d.z == 0.0);
  const Mask by_bottom = slanted & on_disk(planes.bottom, o.z),
             by_top = slanted & on_disk(planes.top, o.z - 1.0);
  const Mask at_top = without(by_top, by_bottom & upward);
  const Numbers cap_t = select(at_top, planes.top, planes.bottom);
  const Mask on_cap = by_bottom | by_top;

  const Mask takes_side = on_side & ((side_t < cap_t) | !on_cap);
  hits.t = select(takes_side, side_t, cap_t);
  const Vectors p = rays.at(hits.t);
  hits.normal =
      select(takes_side, normalized(Vectors(p.x, p.y, 0.0)), Vectors(0.0, 0.0, select(at_top, 1.0, -1.0)));
  hits.u = hits.v = hits.part = 0.0;
  const Mask found = on_side | on_cap;
  const Mask asks_rim = without(active, without(found, dot(hits.normal, d) > 0.0));
  if (any(asks_rim)) unusual |= cross_rim(rays, asks_rim, found, a, c, unsure, sides, roots, planes);
  return found;
}

HWY_INLINE Numbers distance(const Cylinder&, const Vectors& p, const Vectors& normal) {
  const Numbers from_cap = p.z - select(normal.z > 0.0, 1.0, 0.0);
  const Numbers from_side = sqrt(p.x * p.x + p.y * p.y) - 1.0;
  return abs(select(normal.z == 0.0, from_side, from_cap)) + gamma(4) * (1.0 + largest(p));
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
