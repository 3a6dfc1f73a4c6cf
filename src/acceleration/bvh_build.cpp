#include "acceleration/bvh_build.hpp"

#include <algorithm>

#include "acceleration/bvh_split.hpp"
#include "acceleration/parallel_each.hpp"
#include "geometry/rounding.hpp"

namespace trace {
namespace {

// Above so many items the children of a node, and the splits between them, are done side by side.
constexpr std::uint32_t parallel_range = 4096;
constexpr std::size_t parallel_nodes = 4096;  // above, nodes are moved side by side
constexpr std::size_t order_a_run = 1 << 17;

// A subtree: a node, and the subtrees of those of its children that are not in `nodes` themselves.
struct Part {
  LargeVector<BvhNode> nodes;  // nodes[0] is the root
  std::vector<Part> parts;     // of the children of nodes[0], in their order; empty if all are in `nodes`
};

// A node's children to be, of which the first `count` exist.
struct Children {
  BvhRange ranges[bvh_width];
  bool is_leaf[bvh_width];
  int count = 0;

  void add(const BvhRange& range, bool leaf) {
    ranges[count] = range;
    is_leaf[count++] = leaf;
  }
};

// With the leaves' items; the places of nodes are left 0.
BvhNode node_of(const Children& children) {
  FloatBox boxes[bvh_width];
  for (int i = 0; i < bvh_width; ++i) {
    boxes[i] = i < children.count ? children.ranges[i].box : FloatBox::empty();
  }
  BvhNode node;
  for (int i = 0; i < bvh_width; i += 4) {
    const FloatBox* of = boxes + i;
    __m128 low[4] = {of[0].low, of[1].low, of[2].low, of[3].low};
    __m128 high[4] = {of[0].high(), of[1].high(), of[2].high(), of[3].high()};
    _MM_TRANSPOSE4_PS(low[0], low[1], low[2], low[3]);
    _MM_TRANSPOSE4_PS(high[0], high[1], high[2], high[3]);
    for (int axis = 0; axis < 3; ++axis) {
      _mm_store_ps(node.low[axis] + i, low[axis]);
      _mm_store_ps(node.high[axis] + i, high[axis]);
    }
  }
  for (int i = 0; i < bvh_width; ++i) {
    const bool is_leaf = i < children.count && children.is_leaf[i];
    node.child[i] = is_leaf ? children.ranges[i].first : 0;
    node.count[i] = is_leaf ? static_cast<std::uint8_t>(children.ranges[i].size()) : std::uint8_t{0};
  }
  return node;
}

class Builder {
 public:
  Builder(std::span<BoxReference> references, const LeafSizes& leaves, ThreadBudget& threads)
      : references_(references), leaves_(leaves), threads_(threads) {}

  LargeVector<BvhNode> build() const {
    const auto count = static_cast<std::uint32_t>(references_.size());
    Part part;
    const BvhRange all = whole_range(references_, 0, count, 0, threads_);
    if (count <= leaves_.most) {
      Children root;
      root.add(all, true);
      part.nodes.push_back(node_of(root));
    } else {
      subtree(all, part);
    }
    LargeVector<BvhNode> nodes(size_of(part));
    put(part, nodes, 0);
    return nodes;
  }

 private:
  // Of more items than a leaf holds.
  void subtree(const BvhRange& range, Part& part) const {
    if (range.size() > parallel_range) return large(range, part);
    part.nodes.reserve(range.size() / 16 + 1);
    part.nodes.emplace_back();
    small(range, part.nodes, 0);
  }

  // Children by splitting in half, each half, and each of theirs, large ones side by side.
  void open(const BvhRange& range, int levels, Children& children) const {
    BvhHalves halves;
    if (levels == 0 || !split(references_, range, leaves_, threads_, halves)) {
      children.add(range, range.size() <= leaves_.most);
      return;
    }
    Children right;
    const auto open_left = [&] { open(halves.left, levels - 1, children); };
    const auto open_right = [&] { open(halves.right, levels - 1, right); };
    if (range.size() > 2 * parallel_range) {
      threads_.both(open_left, open_right);
    } else {
      open_left();
      open_right();
    }
    for (int i = 0; i < right.count; ++i) children.add(right.ranges[i], right.is_leaf[i]);
  }

  void large(const BvhRange& range, Part& part) const {
    Children children;
    open(range, 3, children);
    std::vector<Part> parts(static_cast<std::size_t>(children.count));
    parallel_each(threads_, parts.size(), [&](std::size_t i) {
      if (!children.is_leaf[i]) subtree(children.ranges[i], parts[i]);
    });
    part.nodes.push_back(node_of(children));
    part.parts = std::move(parts);
  }

  // Children by splitting that with the largest surface until there are eight.
  void small(const BvhRange& range, LargeVector<BvhNode>& nodes, std::uint32_t index) const {
    Children children;
    children.add(range, false);
    float areas[bvh_width] = {range.box.half_area()};
    while (children.count < bvh_width) {
      int widest = -1;
      for (int i = 0; i < children.count; ++i) {
        if (!children.is_leaf[i] && (widest < 0 || areas[i] > areas[widest])) widest = i;
      }
      if (widest < 0) break;
      BvhHalves halves;
      if (!split(references_, children.ranges[widest], leaves_, threads_, halves)) {
        children.is_leaf[widest] = true;
        continue;
      }
      children.ranges[widest] = halves.left;
      areas[widest] = halves.left.box.half_area();
      areas[children.count] = halves.right.box.half_area();
      children.add(halves.right, false);
    }
    for (int i = 0; i < children.count; ++i) {
      children.is_leaf[i] = children.is_leaf[i] || children.ranges[i].size() <= leaves_.most;
    }
    BvhNode node = node_of(children);
    for (int i = 0; i < children.count; ++i) {
      if (children.is_leaf[i]) continue;
      node.child[i] = static_cast<std::uint32_t>(nodes.size());
      nodes.emplace_back();
    }
    nodes[index] = node;
    for (int i = 0; i < children.count; ++i) {
      if (!children.is_leaf[i]) small(children.ranges[i], nodes, node.child[i]);
    }
  }

  static std::size_t size_of(const Part& part) {
    std::size_t result = part.nodes.size();
    for (const Part& below : part.parts) result += size_of(below);
    return result;
  }

  // From place `base` on. Releases the memory of what has been put.
  void put(Part& part, LargeVector<BvhNode>& nodes, std::size_t base) const {
    for (std::size_t i = 0; i < part.nodes.size(); ++i) {
      BvhNode node = part.nodes[i];
      for (int child = 0; child < bvh_width; ++child) {
        if (node.count[child] == 0 && node.child[child] != 0) {
          node.child[child] += static_cast<std::uint32_t>(base);
        }
      }
      nodes[base + i] = node;
    }
    std::vector<std::size_t> bases;
    std::size_t next = base + part.nodes.size();
    for (std::size_t i = 0; i < part.parts.size(); ++i) {
      bases.push_back(next);
      if (!part.parts[i].nodes.empty()) nodes[base].child[i] = static_cast<std::uint32_t>(next);
      next += size_of(part.parts[i]);
    }
    part.nodes = {};
    const auto put_part = [&](std::size_t i) { put(part.parts[i], nodes, bases[i]); };
    if (next - base > parallel_nodes) {
      parallel_each(threads_, bases.size(), put_part);
    } else {
      for (std::size_t i = 0; i < bases.size(); ++i) put_part(i);
    }
  }

  std::span<BoxReference> references_;
  const LeafSizes& leaves_;
  ThreadBudget& threads_;
};

}  // namespace

BvhItems::BvhItems(const Bounds& all, std::size_t most, LargeVector<float> memory)
    : memory_(std::move(memory)) {
  if (memory_.size() < memory_for(most)) memory_.resize(memory_for(most));
  if (!all.empty()) centre_ = 0.5 * all.min + 0.5 * all.max;
  if (!is_finite(centre_)) centre_ = Vec3(0);
  const double size = std::max(largest(all.min), largest(all.max));
  slack_ = static_cast<float>(0x1p-21 * largest(all.max - centre_) + 0x1p-40 * size);
}

Bvh build_bvh(BvhItems&& items, const LeafSizes& leaves, ThreadBudget& threads) {
  Bvh result;
  result.centre = items.centre_;
  for (int axis = 0; axis < 3; ++axis) {
    result.centre_error[axis] = static_cast<float>(0x1p-44 * std::abs(result.centre[axis]));
  }
  result.slack = items.slack_;
  const std::span<BoxReference> references = items.references();
  if (references.empty()) return result;
  result.nodes = Builder(references, leaves, threads).build();
  result.order.resize(references.size());
  parallel_runs(threads, references.size(), order_a_run, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) result.order[i] = references[i].item();
  });
  return result;
}

Bvh build_bvh(std::span<const Bounds> boxes, std::uint32_t max_leaf) {
  Bounds all;
  for (const Bounds& b : boxes) all.add(b);
  BvhItems items(all, boxes.size());
  for (const Bounds& b : boxes) items.add(b);
  ThreadBudget none(1);
  return build_bvh(std::move(items), {1, max_leaf, 1}, none);
}

}  // namespace trace
