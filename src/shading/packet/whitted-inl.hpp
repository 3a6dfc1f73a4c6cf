// The ray trees of a packet: shading/whitted.hpp for packets.
#if defined(TRACE_SHADING_PACKET_WHITTED_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_SHADING_PACKET_WHITTED_INL_HPP
#undef TRACE_SHADING_PACKET_WHITTED_INL_HPP
#else
#define TRACE_SHADING_PACKET_WHITTED_INL_HPP
#endif

#include "shading/contribution.hpp"
#include "shading/packet/local_shading-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

// Packets follow a tree this deep, for a level takes some 20 kB of the stack. What goes on deeper is odd.
inline constexpr int max_packet_bounces = 64;

enum class Kind { visibility, reflection, refraction };

struct Seen {
  Vectors color;
  Numbers t;  // length_of_miss where nothing was hit
};

// shading/secondary_direction.hpp
HWY_INLINE Vectors mirrored_directions(const Vectors& d, const Vectors& n) {
  const Vectors along = dot(n, -d) * n;
  const Vectors across = along + d;
  return along + across;
}
// `bent` loses the lanes of total internal reflection.
HWY_INLINE Vectors refracted_directions(const Vectors& d, const Vectors& n, const Numbers& eta, Mask& bent) {
  const Vectors across = eta * (d - dot(n, d) * n);
  const Numbers k = 1.0 - dot(across, across);
  bent = without(bent, (k < 0.0) | !(eta * 0.0 == 0.0));
  return across - sqrt(k) * n;
}

HWY_INLINE Vectors background(const PacketScene& world, const Vectors& direction, const Mask& missed,
                              const LaneCounts& counts) {
  const CubeMap* surroundings = world.traced.surroundings();
  if (!surroundings) return {0.0, 0.0, 0.0};
  note(counts, &LaneWork::surroundings, missed);
  const VectorLanes d(direction);
  VectorLanes color(Vectors(0.0, 0.0, 0.0));
  for (const std::size_t i : each_lane(missed)) {
    color.set(i, surroundings->lookup(d[i]));
  }
  return color.vectors();
}

// shading/contribution.hpp: the paths of a packet, or the weights of its surfaces. There are none, but a null
// pointer, where no contribution is too small.
struct Paths {
  Numbers weight;
  Vectors glass;  // of the lanes `in_glass`
  Mask in_glass;

  HWY_INLINE Numbers weight_at(const Numbers& t, const Mask& hit, Mask& odd) const {
    const Mask some = without(hit & in_glass, odd);
    if (none(some)) return weight;
    return select(some, weight * largest(transmittances(glass, t, some, odd)), weight);
  }
};

// Takes out of `some` what is too faint to be traced.
HWY_INLINE void leave_out_faint(const PacketScene& world, const Numbers& weight, Mask& some,
                                const LaneCounts& counts) {
  const Mask faint = some & (weight < world.options.least_contribution);
  note(counts, &LaneWork::faint, faint);
  some = without(some, faint);
}

HWY_MAYBE_UNUSED static HWY_NOINLINE void trace_packet(const PacketScene& world, const Rays& rays,
                                                       const Mask& active, Kind kind, int depth,
                                                       const Paths* paths, Seen& seen, LaneCounts& counts,
                                                       Mask& odd);

// `weights` are those of the surfaces, or none.
HWY_MAYBE_UNUSED static HWY_NOINLINE void add_reflected(const PacketScene& world, const Rays& rays,
                                                        const Surfaces& surface, const Mask& inside,
                                                        Mask some, int depth, const Numbers* weights,
                                                        Vectors& color, LaneCounts& counts, Mask& odd) {
  const Materials& material = surface.material;
  Paths paths;
  if (weights) {
    paths = {*weights * largest(material.reflective), material.transmissive,
             inside & !is_zero(material.transmissive)};
    leave_out_faint(world, paths.weight, some, counts);
    if (none(some)) return;
  }
  counts.reflected += where(some, 1.0);
  const Rays mirrored = surface.leaving(mirrored_directions(rays.direction, surface.normal));
  Seen seen;
  trace_packet(world, mirrored, some, Kind::reflection, depth - 1, weights ? &paths : nullptr, seen, counts,
               odd);
  Vectors share = material.reflective;
  const Mask in_glass = without(some & inside & !is_zero(material.transmissive), odd);
  if (any(in_glass)) {
    share = select(in_glass, share * transmittances(material.transmissive, seen.t, in_glass, odd), share);
  }
  const Vectors sum = color + share * seen.color;
  odd |= without(some, all_finite(sum));
  color = select(some, sum, color);
}

HWY_MAYBE_UNUSED static HWY_NOINLINE void add_refracted(const PacketScene& world, const Rays& rays,
                                                        const Surfaces& surface, const Mask& inside,
                                                        Mask some, int depth, const Numbers* weights,
                                                        Vectors& color, LaneCounts& counts, Mask& odd) {
  const Materials& material = surface.material;
  const Vectors n = select(inside, -surface.normal, surface.normal);
  const Numbers eta = select(inside, material.index, 1.0 / material.index);
  const Vectors direction = refracted_directions(rays.direction, n, eta, some);
  const Mask into_glass = without(!is_zero(material.transmissive), inside);
  Paths paths;
  if (weights) {
    paths = {*weights, material.transmissive, into_glass};
    leave_out_faint(world, paths.weight, some, counts);
  }
  if (none(some)) return;
  counts.refracted += where(some, 1.0);
  const Rays bent = surface.leaving(direction);
  Seen seen;
  trace_packet(world, bent, some, Kind::refraction, depth - 1, weights ? &paths : nullptr, seen, counts, odd);
  Vectors light = seen.color;
  const Mask entering = without(some & into_glass, odd);
  if (any(entering)) {
    light = select(entering, transmittances(material.transmissive, seen.t, entering, odd) * light, light);
  }
  const Vectors sum = color + light;
  odd |= without(some, all_finite(sum));
  color = select(some, sum, color);
}

// TracedScene::traces_for_nothing() of the lanes `left`.
HWY_MAYBE_UNUSED static HWY_NOINLINE void trace_for_nothing(const PacketScene& world, const Rays& rays,
                                                            const Surfaces& surface, const Mask& inside,
                                                            const Mask& left, int depth, LaneCounts& counts,
                                                            Mask& odd) {
  Vectors thrown_away(0.0, 0.0, 0.0);
  Mask mirrors_nothing = left & is_zero(surface.material.reflective);
  if (!world.options.internal_reflection) mirrors_nothing = without(mirrors_nothing, inside);
  if (any(mirrors_nothing)) {
    add_reflected(world, rays, surface, inside, mirrors_nothing, depth, nullptr, thrown_away, counts, odd);
  }
  const Mask opaque = without(left & is_zero(surface.material.transmissive), odd);
  if (any(opaque)) {
    add_refracted(world, rays, surface, inside, opaque, depth, nullptr, thrown_away, counts, odd);
  }
}

// WhittedTracer::trace for the lanes `active`. `paths` are those of the rays; none where no contribution is
// too small.
HWY_MAYBE_UNUSED static HWY_NOINLINE void trace_packet(const PacketScene& world, const Rays& rays,
                                                       const Mask& active, Kind kind, int depth,
                                                       const Paths* paths, Seen& seen, LaneCounts& counts,
                                                       Mask& odd) {
  if (world.depth - depth > max_packet_bounces) odd |= active;
  // Of rays that lead nowhere the scalar code knows what is seen.
  odd |= without(active, all_finite(0.0 * rays.origin + rays.direction) & !is_zero(rays.direction));
  const Mask going = without(active, odd);
  seen.color = {0.0, 0.0, 0.0};
  seen.t = length_of_miss;
  if (none(going)) return;
  const bool cull = world.options.backface_culling && kind != Kind::refraction;
  Hits hits;
  closest(world.scene, world.tree, rays, going, cull, hits);
  const Mask hit = going & (hits.t < std::numeric_limits<double>::infinity());
  const Vectors behind = background(world, rays.direction, without(going, hit), counts);
  seen.color = behind;
  if (none(hit)) return;

  Surfaces surface;
  surfaces_of(world.scene, world.options, rays, hits, hit, surface, odd, counts);
  Vectors color = shade_locally(world, surface, rays.direction, without(hit, odd), counts, odd);
  if (depth > 0) {
    const Mask inside = dot(surface.normal, rays.direction) > 0.0;
    Numbers weights;
    const Numbers* weights_if_any = nullptr;
    if (paths) {
      weights = paths->weight_at(hits.t, hit, odd);
      weights_if_any = &weights;
    }
    const Mask left = without(hit, odd);
    Mask reflects = without(left, is_zero(surface.material.reflective));
    if (!world.options.internal_reflection) reflects = without(reflects, inside);
    if (any(reflects)) {
      add_reflected(world, rays, surface, inside, reflects, depth, weights_if_any, color, counts, odd);
    }
    const Mask transmits = without(left, odd | is_zero(surface.material.transmissive));
    if (any(transmits)) {
      add_refracted(world, rays, surface, inside, transmits, depth, weights_if_any, color, counts, odd);
    }
    if (HWY_UNLIKELY(world.traced.traces_for_nothing())) {
      trace_for_nothing(world, rays, surface, inside, without(left, odd), depth, counts, odd);
    }
  }
  seen.color = select(hit, color, behind);
  seen.t = select(hit, hits.t, length_of_miss);
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
