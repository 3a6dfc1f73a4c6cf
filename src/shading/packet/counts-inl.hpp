// shading/ray_counts.hpp for the lanes of a packet: what the tree of each lane's ray took.
#if defined(TRACE_SHADING_PACKET_COUNTS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_SHADING_PACKET_COUNTS_INL_HPP
#undef TRACE_SHADING_PACKET_COUNTS_INL_HPP
#else
#define TRACE_SHADING_PACKET_COUNTS_INL_HPP
#endif

#include "geometry/packet/numbers-inl.hpp"
#include "shading/ray_counts.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

// WorkCounts. Where nobody asks for it there is none, and one test of a pointer is all it costs.
struct LaneWork {
  Numbers culled, from_back, reflects_nothing, out_of_reach, behind;
  Numbers faint, highlights, maps, surroundings;

  HWY_INLINE void clear() {
    culled = from_back = reflects_nothing = out_of_reach = behind = 0.0;
    faint = highlights = maps = surroundings = 0.0;
  }

  // Adds up the lanes `some`.
  HWY_INLINE void add_to(WorkCounts& sum, const Mask& some) const {
    const auto total = [&some](const Numbers& n)
                           HWY_ATTR { return static_cast<std::uint64_t>(sum_of_lanes(where(some, n))); };
    sum.shadows.culled += total(culled);
    sum.shadows.from_back += total(from_back);
    sum.shadows.reflects_nothing += total(reflects_nothing);
    sum.shadows.out_of_reach += total(out_of_reach);
    sum.shadows.behind += total(behind);
    sum.faint += total(faint);
    sum.highlights += total(highlights);
    sum.maps += total(maps);
    sum.surroundings += total(surroundings);
  }
};

struct LaneCounts {
  Numbers reflected, refracted, shadow;
  LaneWork* work;  // none: not counted
};

HWY_INLINE void note(const LaneCounts& counts, Numbers LaneWork::*what, const Mask& some,
                     std::size_t times = 1) {
  if (HWY_LIKELY(!counts.work)) return;
  counts.work->*what += where(some, static_cast<double>(times));
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
