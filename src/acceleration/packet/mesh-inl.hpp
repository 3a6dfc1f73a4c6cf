// A packet of rays through a mesh: MeshTree::closest and occludes for packets.
#if defined(TRACE_ACCELERATION_PACKET_MESH_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_ACCELERATION_PACKET_MESH_INL_HPP
#undef TRACE_ACCELERATION_PACKET_MESH_INL_HPP
#else
#define TRACE_ACCELERATION_PACKET_MESH_INL_HPP
#endif

#include "acceleration/mesh_gaps.hpp"
#include "acceleration/mesh_tree.hpp"
#include "acceleration/packet/traverse-inl.hpp"
#include "acceleration/triangle_filter-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

struct TriangleHits {
  Numbers t, u, v;
};

// meets() of geometry/triangle.hpp: the lanes that hit. `unsure` gets those that meets_after_all() must
// decide. `reach` and `limit` may be larger than a lane's own, which changes no result. Gaps count only up to
// `gap_limit`: a ray that the course's form sees miss the triangle beyond that needs no decision.
HWY_INLINE Mask meet(const Triangle& triangle, const Rays& rays, const Mask& active, double reach,
                     const Numbers& limit, const Numbers& gap_limit, TriangleHits& hits, Mask& unsure) {
  const Vectors ab(triangle.ab), ac(triangle.ac);
  const Vectors p = cross(rays.direction, ac);
  const Numbers determinant = dot(ab, p);
  const Vectors from_a = rays.origin - Vectors(triangle.a);
  const Numbers bound = 64 * unit_roundoff * triangle.size * (reach + triangle.size);

  const Mask turned = determinant < 0.0;
  const Numbers whole = select(turned, -determinant, determinant);
  const Numbers u_dot = dot(from_a, p);
  const Numbers u = select(turned, -u_dot, u_dot);
  const Vectors q = cross(from_a, ab);
  const Numbers v_dot = dot(rays.direction, q);
  const Numbers v = select(turned, -v_dot, v_dot);
  const Numbers t_dot = dot(ac, q);
  const Numbers t = select(turned, -t_dot, t_dot);
  const Numbers t_bound = bound * triangle.size;
  Mask left = without(
      active, (u < -bound) | (u > whole + bound) | (v < -bound) | (u + v > whole + bound) | (t < -t_bound));
  unsure = no_lanes();
  if (none(left)) return left;
  const Numbers square = 6 * triangle.size * triangle.size;
  if (const Mask low = without(left, t > t_bound + square * rays.origin_error); any(low)) {
    unsure = without(low, (rays.origin_error > 0.0) & (t_bound < std::numeric_limits<double>::infinity()));
    const Vec3 normal = glm::cross(triangle.ab, triangle.ac);
    const Numbers own_reach = sum_of_sizes(from_a) + triangle.size;
    const Numbers own_bound = 64 * unit_roundoff * triangle.size * own_reach * triangle.size;
    const Mask in_plane = t <= sum_of_sizes(normal) * rays.origin_error + own_bound;
    left = without(left, unsure | (low & in_plane));
  }
  const Numbers inverse = 1.0 / determinant;
  hits = {t_dot * inverse, u_dot * inverse, v_dot * inverse};
  const Mask thin = without(left, whole > least_determinant(triangle));
  unsure |= thin;
  left = without(left, thin | (hits.t > limit + 0x1p-20 * (limit + Numbers(reach))));
  const Mask certain = (u > bound) & (v > bound) & (u + v < whole - bound);
  const Mask by_course = (hits.u >= 0.0) & (hits.u <= 1.0) & (hits.v >= 0.0) & (hits.u + hits.v <= 1.0);
  const Mask open = without(left, certain | by_course);
  if (any(open)) {
    // t is a quotient of numbers that are off by t_bound and by less than bound; twice that for its rounding.
    const Numbers t_error = 2.0 * (t_bound + abs(hits.t) * bound) / (whole - bound);
    unsure |= without(open, (whole > bound) & (hits.t - t_error > gap_limit));
  }
  return without(left, open) & (hits.t > rays.least_t);
}

// meets_after_all() for the lanes `unsure`, which are added to `hits` or to `gaps`.
HWY_MAYBE_UNUSED static HWY_NOINLINE void meet_after_all(const Corners& corners, const Rays& rays,
                                                         const Mask& unsure, TriangleHits& hits, Mask& hit,
                                                         Mask& gaps) {
  const RayLanes one(rays);
  Lanes t(hits.t), u(hits.u), v(hits.v);
  unsigned found = 0, gap = 0;
  for (const std::size_t i : each_lane(unsure)) {
    TriangleHit result{0, 0, 0};
    const Meeting meeting = meets_after_all(corners, one[i], result);
    if (meeting == Meeting::none) continue;
    (meeting == Meeting::hit ? found : gap) |= 1u << i;
    t.at[i] = result.t;
    u.at[i] = result.u;
    v.at[i] = result.v;
  }
  hits = {t.numbers(), u.numbers(), v.numbers()};
  hit |= mask_of(found);
  gaps = mask_of(gap);
}

// Of the lanes, the furthest way from an origin to a corner of the mesh.
HWY_INLINE double reach_of(const MeshTree& mesh, const Rays& rays, const Mask& active) {
  return largest_lane(active, sum_of_sizes(rays.origin - Vectors(mesh.centre())), 0.0) + mesh.radius();
}

// FilterRay for packets.
class FilterRays {
 public:
  // `reach` is reach_of() the rays.
  HWY_INLINE FilterRays(const MeshTree& mesh, const Rays& rays, double reach)
      : values_(mesh.filter().values.data()),
        origin_{floats_of(rays.origin.x - Numbers(mesh.centre().x)),
                floats_of(rays.origin.y - Numbers(mesh.centre().y)),
                floats_of(rays.origin.z - Numbers(mesh.centre().z))},
        direction_{floats_of(rays.direction.x), floats_of(rays.direction.y), floats_of(rays.direction.z)},
        reach_(FilterRay::rounded_up(reach)) {}

  // As FilterRay::furthest.
  HWY_INLINE Floats furthest(const Numbers& limit) const {
    return hn::Add(floats_of(limit * (1 + 0x1p-19)), hn::Set(FloatTag(), 0x1p-19f * reach_));
  }

  HWY_INLINE void foresee(std::uint32_t first, std::uint32_t count) const {
    fetch_ahead(values_ + TriangleFilter::floats * first, TriangleFilter::floats * count * sizeof(float));
  }

  // Which rays may hit the triangle at `place` of the leaf of `count` that begins with item `first`.
  HWY_INLINE unsigned keep(std::uint32_t first, std::uint32_t count, std::uint32_t place,
                           const Floats& furthest) const {
    const FloatTag f;
    const float* const at = values_ + TriangleFilter::floats * first + place;
    const auto value = [&](std::size_t run) HWY_ATTR { return hn::Set(f, at[run * count]); };
    const Floats corner[3] = {value(0), value(1), value(2)};
    const Floats ab[3] = {value(3), value(4), value(5)}, ac[3] = {value(6), value(7), value(8)};
    return bits_of(may_meet(f, origin_, direction_, hn::Set(f, reach_), furthest, corner, ab, ac, value(9)));
  }

 private:
  const float* values_;
  Floats origin_[3], direction_[3];
  float reach_;
};

class ClosestFaces {
 public:
  HWY_INLINE ClosestFaces(const MeshTree& mesh, const Rays& rays, const Mask& active, const Numbers& limit,
                          bool cull)
      : mesh_(mesh),
        rays_(rays),
        cull_(cull),
        reach_(reach_of(mesh, rays, active)),
        limit_(limit),
        filter_(mesh, rays, reach_),
        going_(active),
        unusual(no_lanes()) {
    best.t = std::numeric_limits<double>::infinity();
    best.u = best.v = 0.0;
    face = 0.0;
  }

  HWY_INLINE void foresee(std::uint32_t first, std::uint32_t count) const { filter_.foresee(first, count); }
  HWY_INLINE bool visit(std::uint32_t first, std::uint32_t count, unsigned touching) {
    Mask changed = no_lanes();
    const Floats furthest = filter_.furthest(limits());
    for (std::uint32_t place = 0; place < count; ++place) {
      const unsigned kept = touching & filter_.keep(first, count, place, furthest);
      if (kept == 0) continue;
      const std::uint32_t i = first + place;
      const Mask asked = mask_of(kept);
      const Triangle triangle = mesh_.triangle(i);
      TriangleHits candidate;
      Mask unsure;
      Mask nearer = meet(triangle, rays_, asked, reach_, best.t, best.t, candidate, unsure);
      if (any(unsure)) {
        Mask gaps;
        meet_after_all(mesh_.corners(i), rays_, unsure, candidate, nearer, gaps);
        gaps = without(gaps, candidate.t > best.t);
        unusual |= gaps;
        going_ = without(going_, gaps);
        changed |= gaps;
      }
      const Numbers number = mesh_.faces()[i].face;
      nearer &= (candidate.t < best.t) | ((candidate.t == best.t) & (number < face));
      if (none(nearer)) continue;
      if (cull_) {
        nearer = without(nearer, dot(Vectors(face_normal(triangle)), rays_.direction) > 0.0);
      }
      best = {select(nearer, candidate.t, best.t), select(nearer, candidate.u, best.u),
              select(nearer, candidate.v, best.v)};
      face = select(nearer, number, face);
      changed |= nearer;
    }
    return any(changed);
  }
  HWY_INLINE Numbers limits() const { return lesser_of(best.t, limit_); }
  HWY_INLINE unsigned going() const { return bits_of(going_); }

 private:
  const MeshTree& mesh_;
  const Rays& rays_;
  bool cull_;
  double reach_;
  Numbers limit_;
  FilterRays filter_;
  Mask going_;

 public:
  TriangleHits best;
  Numbers face;
  Mask unusual;  // to be asked again, ray by ray
};

class AnyFaces {
 public:
  // `limit` is a distance in the world.
  HWY_INLINE AnyFaces(const MeshTree& mesh, const Rays& rays, const Mask& active, const Numbers& scale,
                      const Numbers& limit)
      : mesh_(mesh),
        rays_(rays),
        reach_(reach_of(mesh, rays, active)),
        scale_(scale),
        limit_(limit),
        furthest_(limit * scale * Numbers(1 + gamma(2))),
        gaps_up_to_(limit * scale * Numbers(gaps_before_light)),
        filter_(mesh, rays, reach_),
        furthest_float_(filter_.furthest(furthest_)),
        going_(active),
        found(no_lanes()),
        unusual(no_lanes()) {}

  HWY_INLINE void foresee(std::uint32_t first, std::uint32_t count) const { filter_.foresee(first, count); }
  HWY_INLINE bool visit(std::uint32_t first, std::uint32_t count, unsigned touching) {
    const Mask before = going_;
    for (std::uint32_t place = 0; place < count; ++place) {
      const unsigned kept = touching & filter_.keep(first, count, place, furthest_float_);
      const Mask asked = mask_of(kept) & going_;
      if (none(asked)) continue;
      const std::uint32_t i = first + place;
      TriangleHits candidate;
      Mask unsure;
      Mask met = meet(mesh_.triangle(i), rays_, asked, reach_, furthest_, gaps_up_to_, candidate, unsure);
      Mask gaps = no_lanes();
      if (any(unsure)) meet_after_all(mesh_.corners(i), rays_, unsure, candidate, met, gaps);
      if (none(met | gaps)) continue;
      const Mask hit = met & (candidate.t / scale_ < limit_);
      gaps &= candidate.t < gaps_up_to_;
      found |= hit;
      unusual |= gaps;
      going_ = without(going_, hit | gaps);
    }
    return any(without(before, going_));
  }
  HWY_INLINE Numbers limits() const { return limit_ * scale_; }
  HWY_INLINE unsigned going() const { return bits_of(going_); }

 private:
  const MeshTree& mesh_;
  const Rays& rays_;
  double reach_;
  Numbers scale_, limit_, furthest_, gaps_up_to_;
  FilterRays filter_;
  Floats furthest_float_;
  Mask going_;

 public:
  Mask found;
  Mask unusual;
};

HWY_MAYBE_UNUSED static HWY_NOINLINE Mask intersect_mesh(const MeshTree& mesh, const Rays& rays,
                                                         const Mask& active, const Numbers& limit, bool cull,
                                                         LocalHits& hits, Mask& unusual) {
  ClosestFaces leaf(mesh, rays, active, limit, cull);
  traverse(mesh.bvh(), rays, active, leaf);
  unusual |= leaf.unusual;
  hits = {leaf.best.t, Vectors(0.0, 0.0, 1.0), leaf.best.u, leaf.best.v, leaf.face};
  return without(active, leaf.unusual) & (leaf.best.t < std::numeric_limits<double>::infinity());
}

HWY_MAYBE_UNUSED static HWY_NOINLINE Mask occluded_by_mesh(const MeshTree& mesh, const Rays& rays,
                                                           const Mask& active, const Numbers& scale,
                                                           const Numbers& limit, Mask& unusual) {
  AnyFaces leaf(mesh, rays, active, scale, limit);
  traverse(mesh.bvh(), rays, active, leaf);
  unusual |= leaf.unusual;
  return leaf.found;
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
