#include "shading/packet_tracer.hpp"

#include <algorithm>

#include "shading/foggy.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/packet_tracer.cpp"
#include "hwy/foreach_target.h"
// The kernels, once for each set of instructions.
#include "shading/packet/whitted-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

// shading/foggy.hpp for the lanes `active`.
void put_in_fog(const std::optional<Fog>& fog, const Rays& rays, Seen& seen, const Mask& active, Mask& odd) {
  const VectorLanes origin(rays.origin), direction(rays.direction);
  VectorLanes color(seen.color);
  const Lanes t(seen.t);
  unsigned broken = 0;
  for (const std::size_t i : each_lane(without(active, odd))) {
    const PartialRgb result = in_fog(fog, {origin[i], direction[i]}, PartialRgb(color[i]), t.at[i]);
    color.set(i, result.value);
    if (!result.finite()) broken |= 1u << i;
  }
  seen.color = color.vectors();
  odd |= mask_of(broken);
}

void trace_batch(const TracedScene& traced, int depth, SampleBatch& batch, RayCounts& sum) {
  const PacketScene world{traced, depth};
  const std::optional<Vec3> parallel = RayCaster(world.scene.camera).parallel();
  Rays rays;
  const Vectors eye(world.scene.camera.eye);
  rays.origin = eye;
  rays.origin_error = rays.least_t = 0.0;
  Numbers primary = 0.0;
  LaneCounts total{0.0, 0.0, 0.0, nullptr};
  const Paths whole{1.0, Vectors(0.0, 0.0, 0.0), no_lanes()};
  const Paths* const paths = world.options.least_contribution > 0 ? &whole : nullptr;
  for (std::size_t i = 0; i < batch.count; i += lanes) {
    const Mask active = first_lanes(std::min(lanes, batch.count - i));
    const Vectors given(load(batch.x + i), load(batch.y + i), load(batch.z + i));
    if (HWY_UNLIKELY(parallel.has_value())) {
      rays.origin = eye + given;
      rays.direction = Vectors(*parallel);
    } else {
      rays.direction = normalized(given);
    }
    LaneCounts counts{0.0, 0.0, 0.0, nullptr};
    LaneWork work;
    if (world.options.count_work) {
      work.clear();
      counts.work = &work;
    }
    Mask odd = no_lanes();
    Seen seen;
    trace_packet(world, rays, active, Kind::visibility, depth, paths, seen, counts, odd);
    if (HWY_UNLIKELY(world.scene.fog.has_value())) put_in_fog(world.scene.fog, rays, seen, active, odd);
    const Mask good = without(active, odd);
    primary += where(good, 1.0);
    total.reflected += where(good, counts.reflected);
    total.refracted += where(good, counts.refracted);
    total.shadow += where(good, counts.shadow);
    if (counts.work) work.add_to(sum.work, good);
    store(seen.color.x, batch.red + i);
    store(seen.color.y, batch.green + i);
    store(seen.color.z, batch.blue + i);
    std::fill_n(batch.left_out + i, lanes, false);
    for (const std::size_t k : each_lane(odd)) batch.left_out[i + k] = true;
  }
  sum.primary += static_cast<std::uint64_t>(sum_of_lanes(primary));
  sum.reflected += static_cast<std::uint64_t>(sum_of_lanes(total.reflected));
  sum.refracted += static_cast<std::uint64_t>(sum_of_lanes(total.refracted));
  sum.shadow += static_cast<std::uint64_t>(sum_of_lanes(total.shadow));
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace trace {

PacketTracer::PacketTracer(const TracedScene& world, InstructionSet set, RayCounts& counts)
    : world_(world), set_(set), counts_(counts) {}

void PacketTracer::trace(SampleBatch& batch, int depth) const {
  if (set_ == InstructionSet::baseline || !world_.scene().rules.draws_as_utexas()) {
    std::fill_n(batch.left_out, batch.count, true);
    return;
  }
  switch (set_) {
    case InstructionSet::avx512:
      return N_AVX3::trace_batch(world_, depth, batch, counts_);
    case InstructionSet::avx2:
      return N_AVX2::trace_batch(world_, depth, batch, counts_);
    default:
      return N_SSE4::trace_batch(world_, depth, batch, counts_);
  }
}

}  // namespace trace
#endif
