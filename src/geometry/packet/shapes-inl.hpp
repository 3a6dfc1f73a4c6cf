// Sphere, box and square for packets: the formulas of their intersect(), lane by lane the same bits.
//
// Each takes rays in the space of the object and returns those of the `active` lanes that hit, for which it
// fills `hits`. Lanes for which the scalar code would go ways that have no vector form are added to
// `unusual`; what is returned and filled for them does not count.
#if defined(TRACE_GEOMETRY_PACKET_SHAPES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_GEOMETRY_PACKET_SHAPES_INL_HPP
#undef TRACE_GEOMETRY_PACKET_SHAPES_INL_HPP
#else
#define TRACE_GEOMETRY_PACKET_SHAPES_INL_HPP
#endif

#include <limits>

#include "geometry/box.hpp"
#include "geometry/cone.hpp"
#include "geometry/cylinder.hpp"
#include "geometry/packet/quadratic-inl.hpp"
#include "geometry/sphere.hpp"
#include "geometry/square.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

// hits_bounds() of geometry/bounds.hpp, in its own quotients.
HWY_NOINLINE Mask hit_bounds_exactly(const Bounds& b, const Rays& rays, const Mask& active) {
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

// hits_bounds() of geometry/bounds.hpp. A product with the reciprocal is off by three roundings from the
// quotient, which itself is off by one, or by what underflow loses; where that leaves open which comes first,
// the quotients themselves are asked.
HWY_INLINE Mask hit_bounds(const Bounds& b, const Rays& rays, const Reciprocals& inverse,
                           const Mask& active) {
  const Numbers x1 = (b.min.x - rays.origin.x) * inverse.of.x, x2 = (b.max.x - rays.origin.x) * inverse.of.x;
  const Numbers y1 = (b.min.y - rays.origin.y) * inverse.of.y, y2 = (b.max.y - rays.origin.y) * inverse.of.y;
  const Numbers z1 = (b.min.z - rays.origin.z) * inverse.of.z, z2 = (b.max.z - rays.origin.z) * inverse.of.z;
  const Numbers enter = greatest(least(x1, x2), greatest(least(y1, y2), least(z1, z2)));
  const Numbers leave = least(greatest(x1, x2), least(greatest(y1, y2), greatest(z1, z2)));
  constexpr double smallest = std::numeric_limits<double>::min();
  const Numbers slack = gamma(8) * (abs(enter) + abs(leave)) + smallest;
  const Mask hit = (leave - enter > slack) & (leave > smallest);
  const Mask missed = (enter - leave > slack) | (leave < -smallest);
  const Mask open = without(active, inverse.finite & (hit | missed));
  const Mask certain = active & hit & inverse.finite;
  return none(open) ? certain : without(certain, open) | hit_bounds_exactly(b, rays, open);
}

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

HWY_INLINE Mask intersect(const Box&, const Rays& rays, const Mask& active, LocalHits& hits, Mask& unusual) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const Numbers o[3] = {rays.origin.x, rays.origin.y, rays.origin.z};
  const Numbers d[3] = {rays.direction.x, rays.direction.y, rays.direction.z};
  hits.t = inf;
  Numbers best_face = -1.0;
  Numbers enter = -inf, leave = inf;
  for (int face = 0; face < 6; ++face) {
    const int axis = face % 3, next = (axis + 1) % 3, last = (axis + 2) % 3;
    const double plane = face / 3 - 0.5;
    const Numbers above = plane - o[axis];
    const Numbers t = above / d[axis];
    const Mask moves = !(d[axis] == 0.0);
    const Numbers a = o[next] + t * d[next], b = o[last] + t * d[last];
    const Mask meets = moves & (t > rays.least_t) & (t < hits.t) & !(abs(above) <= rays.origin_error) &
                       (a >= -0.5) & (a <= 0.5) & (b >= -0.5) & (b <= 0.5);
    hits.t = select(meets, t, hits.t);
    best_face = select(meets, Numbers(face), best_face);
    // Where the ray comes in and goes out of all pairs of planes.
    const Mask comes_in = face < 3 ? d[axis] > 0.0 : d[axis] < 0.0;
    enter = select(comes_in & (t > enter), t, enter);
    leave = select(without(moves, comes_in) & (t < leave), t, leave);
  }
  const Mask found = active & (best_face >= 0.0);
  // What face_across() of box.cpp might find is left to it.
  unusual |= without(active, found) & (leave >= enter) & (leave > rays.least_t);

  const Vectors p = rays.at(hits.t);
  const Mask min_face = best_face < 3.0;
  const Numbers outward = select(min_face, -1.0, 1.0);
  const Mask across_x = (best_face == 0.0) | (best_face == 3.0),
             across_z = (best_face == 2.0) | (best_face == 5.0);
  const Mask across_y = !(across_x | across_z);
  hits.normal = {where(across_x, outward), where(across_y, outward), where(across_z, outward)};
  const Numbers low = select(across_x, p.y, p.x), high = select(across_z, p.y, p.z);
  hits.u = select(min_face, 0.5 - low, 0.5 + low);
  hits.v = 0.5 + high;
  hits.part = 0.0;
  return found;
}

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

// A shape without a vector form: one ray after the other.
template <class Shape>
Mask intersect(const Shape& shape, const Rays& rays, const Mask& active, LocalHits& hits, Mask& unusual) {
  const RayLanes one(rays);
  Lanes t, nx, ny, nz;
  unsigned found = 0, gaps = 0;
  for (unsigned left = bits_of(active); left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(left));
    LocalHit hit;
    if (!shape.intersect(one[i], hit)) continue;
    (hit.is_gap ? gaps : found) |= 1u << i;
    t.at[i] = hit.t;
    nx.at[i] = hit.normal.x;
    ny.at[i] = hit.normal.y;
    nz.at[i] = hit.normal.z;
  }
  hits = {t.numbers(), {nx.numbers(), ny.numbers(), nz.numbers()}, 0.0, 0.0, 0.0};
  unusual |= mask_of(gaps);
  return mask_of(found);
}

// How far a point is from the surface that was hit: distance() of each shape, with the rounding of its
// formula.
HWY_INLINE Numbers distance(const Sphere&, const Vectors& p, const Vectors&) {
  return abs(sqrt(dot(p, p)) - 1.0) + gamma(4);
}
HWY_INLINE Numbers distance(const Square&, const Vectors& p, const Vectors&) {
  return abs(p.z) + gamma(4);
}
HWY_INLINE Numbers distance(const Box&, const Vectors& p, const Vectors& normal) {
  const Mask x = !(normal.x == 0.0), y = !(normal.y == 0.0);
  const Numbers along = select(x, p.x, select(y, p.y, p.z));
  const Numbers outward = select(x, normal.x, select(y, normal.y, normal.z));
  return abs(along - 0.5 * outward) + gamma(4) * (1.0 + largest(p));
}
template <class Shape>
Numbers distance(const Shape& shape, const Vectors& p, const Vectors& normal) {
  const Lanes px(p.x), py(p.y), pz(p.z), nx(normal.x), ny(normal.y), nz(normal.z);
  Lanes result;
  for (std::size_t i = 0; i < lanes; ++i) {
    result.at[i] = shape.distance(Vec3(px.at[i], py.at[i], pz.at[i]), Vec3(nx.at[i], ny.at[i], nz.at[i]));
  }
  return result.numbers() + gamma(4) * (1.0 + largest(p));
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
