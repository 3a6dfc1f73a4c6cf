// How hierarchies are built.
#pragma once

#include <span>
#include <utility>

#include "acceleration/bvh.hpp"
#include "acceleration/bvh_reference.hpp"
#include "acceleration/large_vector.hpp"
#include "acceleration/parallel_each.hpp"
#include "parallel/parallel.hpp"

namespace trace {

// Leaves hold up to `most` items (1 to 255): so few never get a node of their own. Where a node has room for
// more children, ranges above `always` are split further if two halves cost less, with the test of one more
// box at `box` items' tests.
struct LeafSizes {
  std::uint32_t always = 1;
  std::uint32_t most = 4;
  float box = 1;
};

// References to items of which each has a box, and the space they are in.
class BvhItems {
 public:
  // `all` encloses the items, of which there will be `count`.
  BvhItems(const Bounds& all, std::size_t count);

  // The same with all of them: box(i) is the low and the high corner of item i. Done side by side.
  template <class Box>
  BvhItems(const Bounds& all, std::size_t count, ThreadBudget& threads, const Box& box)
      : BvhItems(all, count) {
    references_.resize(count);
    parallel_runs(threads, count, items_a_run, [&](std::size_t first, std::size_t last) {
      const DoubleLanes centre = DoubleLanes::load(centre_);
      for (std::size_t i = first; i < last; ++i) {
        const std::pair<DoubleLanes, DoubleLanes> corners = box(i);
        references_[i] = outward(static_cast<std::uint32_t>(i), corners.first, corners.second, centre);
      }
    });
  }

  void add(const Bounds& b) {
    references_.push_back(outward(static_cast<std::uint32_t>(references_.size()), DoubleLanes::load(b.min),
                                  DoubleLanes::load(b.max), DoubleLanes::load(centre_)));
  }

 private:
  friend Bvh build_bvh(BvhItems items, const LeafSizes& leaves, ThreadBudget& threads);

  static constexpr std::size_t items_a_run = 8192;

  LargeVector<BoxReference> references_;
  Vec3 centre_{0};
  float slack_ = 0;
};

// Top down by split() (bvh_split.hpp), of a node's children the one with the largest surface first. The
// hierarchy depends on the items alone, not on the number of threads.
Bvh build_bvh(BvhItems items, const LeafSizes& leaves, ThreadBudget& threads);

// The same of a list of boxes on one thread.
Bvh build_bvh(std::span<const Bounds> boxes, std::uint32_t max_leaf);

}  // namespace trace
