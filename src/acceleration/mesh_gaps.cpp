#include "acceleration/mesh_gaps.hpp"

#include <algorithm>

namespace trace {

bool MeshGaps::counts(const MeshGap& gap) const {
  if (!gap.on_edge) return true;
  return std::any_of(gaps_.begin(), gaps_.end(), [&](const MeshGap& other) {
    return other.face != gap.face && other.on_edge && other.from_behind == gap.from_behind &&
           same_place(other.hit.t, gap.hit.t);
  });
}

const MeshGap* MeshGaps::nearest() const {
  const MeshGap* best = nullptr;
  for (const MeshGap& gap : gaps_) {
    const bool nearer =
        !best || gap.hit.t < best->hit.t || (gap.hit.t == best->hit.t && gap.face < best->face);
    if (nearer && counts(gap)) best = &gap;
  }
  return best;
}

}  // namespace trace
