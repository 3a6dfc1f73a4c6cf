// Where to split a range of items in two, and whether: the binned surface-area heuristic (Wald, "On fast
// Construction of SAH-based Bounding Volume Hierarchies", 2007).
#pragma once

#include <span>

#include "acceleration/bvh_build.hpp"
#include "acceleration/bvh_reference.hpp"
#include "parallel/parallel.hpp"

namespace trace {

// A run of references with the box around them and the box of their boxes' centres, times two.
struct BvhRange {
  FloatBox box, centres;
  std::uint32_t first, last;
  int depth;  // splits above

  std::uint32_t size() const { return last - first; }
};

// [first, last) with its boxes.
BvhRange whole_range(std::span<const BoxReference> references, std::uint32_t first, std::uint32_t last,
                     int depth, ThreadBudget& threads);

struct BvhHalves {
  BvhRange left, right;
};

// Reorders the references of `range` so that both halves are runs; false where a leaf costs less, which it
// never does of more than leaves.most. The result depends on the references alone.
bool split(std::span<BoxReference> references, const BvhRange& range, const LeafSizes& leaves,
           ThreadBudget& threads, BvhHalves& halves);

}  // namespace trace
