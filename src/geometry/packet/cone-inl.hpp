// The cone for packets; see shapes-inl.hpp. Nothing is unusual.
#if defined(TRACE_GEOMETRY_PACKET_CONE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_GEOMETRY_PACKET_CONE_INL_HPP
#undef TRACE_GEOMETRY_PACKET_CONE_INL_HPP
#else
#define TRACE_GEOMETRY_PACKET_CONE_INL_HPP
#endif

#include "geometry/cone.hpp"
#include "geometry/packet/quadratic-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

// Cone::side_roots(): the lanes with roots. `from_apex` is the origin seen from the apex.
HWY_INLINE Mask meet_endless_cone(double slope2, const Rays& rays, const Vectors& from_apex,
                                  const Mask& active, ManyRoots& roots) {
  const Vectors &f = from_apex, &d = rays.direction;
  const Numbers a = d.x * d.x + d.y * d.y - slope2 * d.z * d.z;
  const Numbers b = 2.0 * (f.x * d.x + f.y * d.y - slope2 * f.z * d.z);
  const Numbers reach2 = f.x * f.x + f.y * f.y, cone2 = slope2 * f.z * f.z;
  const Numbers c = reach2 - cone2;
  const Numbers discriminant = b * b - 4.0 * a * c;
  const Numbers gradient = abs(f.x) + abs(f.y) + slope2 * abs(f.z);
  const Numbers error = rays.origin_error;
  const Mask on_surface =
      abs(c) <= error * (2.0 * gradient + (2 + slope2) * error) + gamma(6) * (reach2 + cone2);
  const Mask no_square = a == 0.0;
  const Mask linear = !(abs(4.0 * a * c) > 0x1p-12 * b * b);
  const Mask loses_a_root = without(linear, without(on_surface, no_square));
  const Mask good =
      without(is_well_conditioned(discriminant, b * b + 4.0 * abs(a) * (reach2 + cone2)), loses_a_root);

  const Numbers root = sqrt(discriminant);
  roots = {(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)};
  Mask meet = without(discriminant > 0.0, no_square);
  if (any(without(active, good))) {
    const Vectors moment = accurate_cross(f, d);
    const Numbers across = slope2 * (moment.x * moment.x + moment.y * moment.y),
                  along_axis = moment.z * moment.z;
    const Numbers value = across - along_axis;
    const Mask decided = without(is_decided(value, across + along_axis), good);
    roots = select(decided, stable_roots(a, 0.5 * b, c, sqrt(value)), roots);
    meet = without(meet, decided) | without(decided, value < 0.0);
  }
  const Mask first_is_origin = abs(roots.first) < abs(roots.second);
  roots.first = select(on_surface & first_is_origin, 0.0, roots.first);
  roots.second = select(without(on_surface, first_is_origin), 0.0, roots.second);
  return active & meet;
}

HWY_INLINE Mask intersect(const Cone& cone, const Rays& rays, const Mask& active, LocalHits& hits, Mask&) {
  const Vectors &o = rays.origin, &d = rays.direction;
  const double slope = cone.slope(), height = cone.height();
  const Vectors from_apex(o.x, o.y, o.z + cone.apex_offset());
  ManyRoots roots;
  const Mask asked = meet_endless_cone(slope * slope, rays, from_apex, active, roots);
  if (none(asked)) return asked;

  const auto rounding = [](const Numbers& t, const Numbers& from, const Numbers& along)
                            HWY_ATTR { return gamma(8) * (abs(from) + abs(t * along)); };
  const auto on_side = [&](const Numbers& t) HWY_ATTR {
    const Numbers z = o.z + t * d.z, slack = rounding(t, o.z, d.z);
    return (z >= -slack) & (z <= height + slack) & (slack <= height);
  };
  const Numbers &r1 = roots.second, &r2 = roots.first, &least_t = rays.least_t;
  const Mask good1 = on_side(r1), good2 = on_side(r2);
  hits.t = select(good1 & (r1 > least_t), r1, least_t);
  hits.t = select(good2 & ((good1 & (r2 < hits.t)) | (r2 > least_t)), r2, hits.t);
  const Vectors p = rays.at(hits.t);
  hits.normal = normalized(Vectors(p.x, p.y, -2 * slope * slope * (p.z + cone.apex_offset())));

  if (cone.capped()) {
    const auto try_cap = [&](double z, double radius, double facing) HWY_ATTR {
      const Numbers below = z - o.z, t = below / d.z;
      const Numbers x = o.x + t * d.x, y = o.y + t * d.y;
      const Numbers slack = 2.0 * (abs(x) * rounding(t, o.x, d.x) + abs(y) * rounding(t, o.y, d.y));
      const Mask nearer = without((t > least_t) & (t < hits.t) & (x * x + y * y <= radius * radius + slack),
                                  abs(below) <= rays.origin_error);
      hits.t = select(nearer, t, hits.t);
      const Numbers up = select(d.z > 0.0, -facing, facing);
      hits.normal = select(nearer, Vectors(0.0, 0.0, up), hits.normal);
    };
    try_cap(0, cone.bottom_radius(), 1);
    try_cap(height, cone.top_radius(), -1);
  } else {
    hits.normal = select(dot(hits.normal, d) > 0.0, -hits.normal, hits.normal);
  }
  hits.u = hits.v = hits.part = 0.0;
  return asked & (hits.t > least_t);
}

HWY_INLINE Numbers distance(const Cone& cone, const Vectors& p, const Vectors& normal) {
  const Numbers from_caps = lesser_of(abs(p.z), abs(p.z - cone.height()));
  const Numbers radius = sqrt(p.x * p.x + p.y * p.y);
  const Numbers from_side = abs(radius - abs(cone.slope() * (p.z + cone.apex_offset())));
  const Mask on_cap = (normal.x == 0.0) & (normal.y == 0.0);
  return select(on_cap, from_caps, from_side) + gamma(4) * (1.0 + largest(p));
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
