// The box for packets; see shapes-inl.hpp.
#if defined(TRACE_GEOMETRY_PACKET_BOX_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_GEOMETRY_PACKET_BOX_INL_HPP
#undef TRACE_GEOMETRY_PACKET_BOX_INL_HPP
#else
#define TRACE_GEOMETRY_PACKET_BOX_INL_HPP
#endif

#include <limits>

#include "geometry/box.hpp"
#include "geometry/packet/rays-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

HWY_INLINE Mask intersect(const Box&, const Rays& rays, const Mask& active, LocalHits& hits, Mask& unusual) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const Numbers o[3] = {rays.origin.x, rays.origin.y, rays.origin.z};
  const Numbers d[3] = {rays.direction.x, rays.direction.y, rays.direction.z};
  hits.t = inf;
  Numbers best_face = -1.0;
  Numbers meets_at[6];
  for (int face = 0; face < 6; ++face) {
    const int axis = face % 3, next = (axis + 1) % 3, last = (axis + 2) % 3;
    const double plane = face / 3 - 0.5;
    const Numbers above = plane - o[axis];
    const Numbers t = meets_at[face] = above / d[axis];
    const Numbers a = o[next] + t * d[next], b = o[last] + t * d[last];
    // Along an axis on which the ray does not move t is infinite or not a number, and not below hits.t.
    const Mask meets = (t > rays.least_t) & (t < hits.t) & !(abs(above) <= rays.origin_error) &
                       (greatest(abs(a), abs(b)) <= 0.5);
    hits.t = select(meets, t, hits.t);
    best_face = select(meets, Numbers(face), best_face);
  }
  const Mask found = active & (best_face >= 0.0);
  // What face_across() of box.cpp might find is left to it: where the ray comes in through all pairs of
  // planes before it goes out of any.
  if (const Mask asked = without(active, found); any(asked)) {
    Numbers enter = -inf, leave = inf;
    Mask beside = no_lanes();
    for (int axis = 0; axis < 3; ++axis) {
      const Mask still = d[axis] == 0.0;
      beside |= still & (abs(o[axis]) > 0.5);
      enter = greatest(enter, select(still, -inf, least(meets_at[axis], meets_at[axis + 3])));
      leave = least(leave, select(still, inf, greatest(meets_at[axis], meets_at[axis + 3])));
    }
    unusual |= without(asked, beside) & (leave >= enter) & (leave > rays.least_t);
  }

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

HWY_INLINE Numbers distance(const Box&, const Vectors& p, const Vectors& normal) {
  const Mask x = !(normal.x == 0.0), y = !(normal.y == 0.0);
  const Numbers along = select(x, p.x, select(y, p.y, p.z));
  const Numbers outward = select(x, normal.x, select(y, normal.y, normal.z));
  return abs(along - 0.5 * outward) + gamma(4) * (1.0 + largest(p));
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
