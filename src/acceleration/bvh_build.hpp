// How hierarchies are built.
#pragma once

#include <new>
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
  // `all` encloses the items, of which there will be at most `most`.
  BvhItems(const Bounds& all, std::size_t most) : BvhItems(all, most, LargeVector<float>()) {}

  // The same with all of them: box(i) is the low and the high corner of item i. Done side by side. `memory`,
  // of at least memory_for(count) floats, is what the references are kept in.
  template <class Box>
  BvhItems(const Bounds& all, std::size_t count, LargeVector<float> memory, ThreadBudget& threads,
           const Box& box)
      : BvhItems(all, count, std::move(memory)) {
    count_ = count;
    parallel_runs(threads, count, items_a_run, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const std::pair<DoubleLanes, DoubleLanes> corners = box(i);
        put(i, corners.first, corners.second);
      }
    });
  }

  void add(const Bounds& b) { put(count_++, DoubleLanes::load(b.min), DoubleLanes::load(b.max)); }

  // When the hierarchy has been built, for other use.
  LargeVector<float> take_memory() { return std::move(memory_); }

  static std::size_t memory_for(std::size_t items) { return items * (sizeof(BoxReference) / sizeof(float)); }

 private:
  friend Bvh build_bvh(BvhItems&& items, const LeafSizes& leaves, ThreadBudget& threads);

  static constexpr std::size_t items_a_run = 1 << 14;

  BvhItems(const Bounds& all, std::size_t most, LargeVector<float> memory);

  std::span<BoxReference> references() {
    return {std::launder(reinterpret_cast<BoxReference*>(memory_.data())), count_};
  }
  void put(std::size_t i, const DoubleLanes& low, const DoubleLanes& high) {
    ::new (static_cast<void*>(memory_.data() + memory_for(i)))
        BoxReference(outward(static_cast<std::uint32_t>(i), low, high, DoubleLanes::load(centre_)));
  }

  LargeVector<float> memory_;
  std::size_t count_ = 0;
  Vec3 centre_{0};
  float slack_ = 0;
};

// Top down by split() (bvh_split.hpp), of a node's children the one with the largest surface first. The
// hierarchy depends on the items alone, not on the number of threads. Of `items` only the memory is left.
Bvh build_bvh(BvhItems&& items, const LeafSizes& leaves, ThreadBudget& threads);

// The same of a list of boxes on one thread.
Bvh build_bvh(std::span<const Bounds> boxes, std::uint32_t max_leaf);

}  // namespace trace
