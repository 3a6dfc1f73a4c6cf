// The rays of single_frame.cpp in packets: blocks of four by four, four by two or two by two pixels, as many
// as a packet holds, and from their hits to one light after the other or mirrored.
#include "instruction_set/instruction_set.hpp"
#include "tools/benchmark/kernels/frame_rays.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tools/benchmark/kernels/coherent_frame.cpp"
#include "hwy/foreach_target.h"
// The kernels, once for each set of instructions.
#include "shading/packet/whitted-inl.hpp"
#include "tools/benchmark/kernels/mesh_hits-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

class CoherentFrame {
 public:
  CoherentFrame(const Scene& scene, const SceneTree& tree, bench::FrameSize size, bench::Mode mode,
                const Vec3& extra_light)
      : scene_(scene), tree_(tree), size_(size), mode_(mode), caster_(scene.camera) {
    extra_.position = extra_light;
  }

  bench::FrameCounts trace() {
    for (int top = 0; top < size_.height; top += bench::tile_side) {
      for (int left = 0; left < size_.width; left += bench::tile_side) trace_tile(left, top);
    }
    return counts_;
  }

 private:
  static constexpr int across = lanes < 8 ? 2 : 4;
  static constexpr int along = static_cast<int>(lanes) / across;

  HWY_INLINE void trace_tile(int left, int top) {
    for (int y = top; y < std::min(size_.height, top + bench::tile_side); y += along) {
      for (int x = left; x < std::min(size_.width, left + bench::tile_side); x += across) trace_block(x, y);
    }
  }

  HWY_INLINE void trace_block(int left, int top) {
    VectorLanes directions;
    unsigned inside = 0;
    for (std::size_t i = 0; i < lanes; ++i) {
      const int x = left + static_cast<int>(i) % across, y = top + static_cast<int>(i) / across;
      if (x < size_.width && y < size_.height) inside |= 1u << i;
      directions.set(i, caster_.across(double(x) / size_.width) + caster_.upward(double(y) / size_.height));
    }
    const Mask active = mask_of(inside);
    const Rays rays{scene_.camera.eye, normalized(directions.vectors()), 0.0, 0.0};
    Hits hits;
    closest(scene_, tree_, rays, active, false, hits);
    Mask hit = active & (hits.t < std::numeric_limits<double>::infinity());
    counts_.primary += count(active);
    counts_.hits += count(hit);
    counts_.distances += sum_of_lanes(where(hit, hits.t));
    if (mode_ == bench::Mode::primary || none(hit)) return;
    const MeshHits surface = mesh_hits_of(scene_, rays, hits, hit);
    if (mode_ == bench::Mode::one_shadow) {
      trace_shadow(surface, extra_, hit, false);
    } else if (mode_ == bench::Mode::mirrored) {
      trace_mirrored(rays, surface, hit);
    } else {
      for (const Light& light : scene_.lights) {
        if (const auto* point = std::get_if<PointLight>(&light)) {
          trace_shadow(surface, *point, hit, true);
        } else if (const auto* far = std::get_if<DirectionalLight>(&light)) {
          trace_shadow(surface, *far, hit, true);
        }
      }
    }
  }

  template <class Light>
  HWY_INLINE void trace_shadow(const MeshHits& from, const Light& light, Mask lit, bool only_in_front) {
    Mask odd = no_lanes();
    const LightSamples sample = sample_of(light, from.point, lit, odd);
    if (only_in_front) lit &= dot(sample.towards, from.normal) > 0.0;
    if (none(lit)) return;
    counts_.shadow += count(lit);
    counts_.occluded +=
        count(occluded(scene_, tree_, from.leaving(sample.towards), lit, sample.distance) & lit);
  }

  HWY_INLINE void trace_mirrored(const Rays& rays, const MeshHits& from, const Mask& hit) {
    counts_.mirrored += count(hit);
    Hits next;
    closest(scene_, tree_, from.leaving(mirrored_directions(rays.direction, from.normal)), hit, false, next);
    counts_.distances +=
        sum_of_lanes(where(hit & (next.t < std::numeric_limits<double>::infinity()), next.t));
  }

  const Scene& scene_;
  const SceneTree& tree_;
  bench::FrameSize size_;
  bench::Mode mode_;
  RayCaster caster_;
  PointLight extra_;
  bench::FrameCounts counts_;
};

bench::FrameCounts coherent_frame(const Scene& scene, const SceneTree& tree, bench::FrameSize size,
                                  bench::Mode mode, const Vec3& extra_light) {
  return CoherentFrame(scene, tree, size, mode, extra_light).trace();
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace trace::bench {

bool has_coherent_frames() {
  return best_instruction_set() != InstructionSet::baseline;
}

FrameCounts coherent_frame(const Scene& scene, const SceneTree& tree, FrameSize size, Mode mode,
                           const Vec3& extra_light) {
  switch (best_instruction_set()) {
    case InstructionSet::avx512:
      return N_AVX3::coherent_frame(scene, tree, size, mode, extra_light);
    case InstructionSet::avx2:
      return N_AVX2::coherent_frame(scene, tree, size, mode, extra_light);
    default:
      return N_SSE4::coherent_frame(scene, tree, size, mode, extra_light);
  }
}

}  // namespace trace::bench
#endif
