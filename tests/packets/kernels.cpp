#include "tests/packets/kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/packets/kernels.cpp"
#include "hwy/foreach_target.h"
// Once for each set of instructions.
#include "acceleration/packet/scene-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {
namespace for_tests {

using test::NormalAnswer;
using test::ObjectRayAnswer;
using test::ShapeAnswer;

// Lanes beyond the last get what it has.
Vectors gather(std::span<const Vec3> v) {
  VectorLanes result;
  for (std::size_t i = 0; i < lanes; ++i) result.set(i, v[std::min(i, v.size() - 1)]);
  return result.vectors();
}
Numbers gather(std::span<const double> v) {
  Lanes result;
  for (std::size_t i = 0; i < lanes; ++i) result.at[i] = v[std::min(i, v.size() - 1)];
  return result.numbers();
}
Rays gather(std::span<const Ray> rays) {
  std::vector<Vec3> origins, directions;
  std::vector<double> errors, least_ts;
  for (const Ray& ray : rays) {
    origins.push_back(ray.origin);
    directions.push_back(ray.direction);
    errors.push_back(ray.origin_error);
    least_ts.push_back(ray.least_t);
  }
  return {gather(origins), gather(directions), gather(errors), gather(least_ts)};
}

Vec3 vector_at(const Vectors& v, std::size_t i) {
  return VectorLanes(v)[i];
}
LocalHit hit_at(const LocalHits& hits, std::size_t i) {
  LocalHit hit;
  hit.t = lane(hits.t, i);
  hit.normal = vector_at(hits.normal, i);
  hit.uv = Vec2(lane(hits.u, i), lane(hits.v, i));
  hit.part = static_cast<std::uint32_t>(lane(hits.part, i));
  return hit;
}

std::vector<ShapeAnswer> intersect_shape(const Shape& shape, std::span<const Ray> given, unsigned active) {
  const Rays rays = gather(given);
  LocalHits hits;
  hits.t = hits.u = hits.v = hits.part = 0.0;
  hits.normal = {0.0, 0.0, 0.0};
  Mask unusual = no_lanes();
  const unsigned found = bits_of(intersect_primitive(shape, rays, mask_of(active), hits, unusual));
  const unsigned odd = bits_of(unusual);
  std::vector<ShapeAnswer> result(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    result[i].unusual = (odd >> i & 1) != 0;
    result[i].found = (found >> i & 1) != 0;
    if (result[i].found) result[i].hit = hit_at(hits, i);
  }
  return result;
}

std::vector<double> distance_to(const Shape& shape, std::span<const Vec3> points,
                                std::span<const Vec3> normals) {
  const Numbers all = with_primitive(
      shape, [&](const auto& s) HWY_ATTR { return distance(s, gather(points), gather(normals)); });
  std::vector<double> result;
  for (std::size_t i = 0; i < points.size(); ++i) result.push_back(lane(all, i));
  return result;
}

unsigned hit_box(const Bounds& bounds, std::span<const Ray> given, unsigned active) {
  const Rays rays = gather(given);
  return bits_of(hit_bounds(bounds, rays, Reciprocals(rays), mask_of(active)));
}

std::vector<ObjectRayAnswer> carry(const Frame& frame, std::span<const Ray> given) {
  ObjectRays local;
  local.carry(frame, gather(given));
  const RayLanes one(local.rays);
  const unsigned odd = bits_of(local.unusual);
  std::vector<ObjectRayAnswer> result;
  for (std::size_t i = 0; i < given.size(); ++i) {
    result.push_back({(odd >> i & 1) != 0, one[i], lane(local.scale, i)});
  }
  return result;
}

std::vector<NormalAnswer> normals_of(const Frame& frame, std::span<const Vec3> normals) {
  Mask unusual = no_lanes();
  const Vectors all = world_normals(frame, gather(normals), unusual);
  const unsigned odd = bits_of(unusual);
  std::vector<NormalAnswer> result;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    result.push_back({(odd >> i & 1) != 0, vector_at(all, i)});
  }
  return result;
}

std::vector<Hit> closest_hits(const Scene& scene, const SceneTree& tree, std::span<const Ray> given,
                              unsigned active, bool cull) {
  Hits hits;
  closest(scene, tree, gather(given), mask_of(active), cull, hits);
  std::vector<Hit> result(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    if ((active >> i & 1) == 0) continue;
    result[i].t = lane(hits.t, i);
    if (!result[i]) continue;
    result[i].object = static_cast<std::uint32_t>(lane(hits.object, i));
    result[i].local = hit_at(hits.local, i);
  }
  return result;
}

unsigned occluded_rays(const Scene& scene, const SceneTree& tree, std::span<const Ray> rays, unsigned active,
                       std::span<const double> limits) {
  return bits_of(occluded(scene, tree, gather(rays), mask_of(active), gather(limits)));
}

constexpr test::PacketKernels all(InstructionSet set) {
  return {set, lanes, intersect_shape, distance_to, hit_box, carry, normals_of, closest_hits, occluded_rays};
}

}  // namespace for_tests
}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace trace::test {

std::vector<PacketKernels> packet_kernels() {
  std::vector<PacketKernels> result;
  for (const PacketKernels& kernels :
       {N_SSE4::for_tests::all(InstructionSet::sse4), N_AVX2::for_tests::all(InstructionSet::avx2),
        N_AVX3::for_tests::all(InstructionSet::avx512)}) {
    if (kernels.set <= best_instruction_set()) result.push_back(kernels);
  }
  return result;
}

}  // namespace trace::test
#endif
