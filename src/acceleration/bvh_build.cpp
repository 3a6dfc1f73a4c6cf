#include "acceleration/bvh_build.hpp"

#include <algorithm>

#include "acceleration/bvh_split.hpp"
#include "acceleration/parallel_each.hpp"
#include "geometry/rounding.hpp"

namespace trace {
namespace {

// Above so many items the children of a node, and the splits between them, are done side by side.
constexpr std::uint32_t parallel_size = 4096;

// A subtree: a node, and the subtrees of those of its children that are not in `nodes` themselves.
struct Part {
  std::vector<BvhNode> nodes;  // nodes[0] is the root
  std::vector<Part> parts;     // of the children of nodes[0], in their order; empty if all are in `nodes`
};

class Builder {
 public:
  Builder(std::span<BoxReference> references, const LeafSizes& leaves, ThreadBudget& threads)
      : references_(references), leaves_(leaves), threads_(threads) {}

  std::vector<BvhNode> build() {
    const auto count = static_cast<std::uint32_t>(references_.size());
    Part part;
    const BvhRange all = whole_range(references_, 0, count, 0, threads_);
    if (!subtree(all, part)) {
      Children root;
      root.add(all, true);
      part.nodes.push_back(node_of(root));
    }
    std::vector<BvhNode> nodes;
    nodes.reserve(size_of(part));
    append(part, nodes);
    return nodes;
  }

 private:
  struct Children {
    BvhRange ranges[bvh_width];
    bool is_leaf[bvh_width];
    int count = 0;

    void add(const BvhRange& range, bool leaf) {
      ranges[count] = range;
      is_leaf[count++] = leaf;
    }
  };

  std::optional<BvhHalves> halves(const BvhRange& range) const {
    return split(references_, range, leaves_, threads_);
  }

  static BvhNode node_of(const Children& children) {
    BvhNode node{};
    for (int i = 0; i < bvh_width; ++i) {
      const FloatBox box = i < children.count ? children.ranges[i].box : FloatBox{};
      alignas(16) float low[4], high[4];
      _mm_store_ps(low, box.low);
      _mm_store_ps(high, box.high());
      for (int axis = 0; axis < 3; ++axis) {
        node.low[axis][i] = low[axis];
        node.high[axis][i] = high[axis];
      }
      if (i < children.count && children.is_leaf[i]) {
        node.child[i] = children.ranges[i].first;
        node.count[i] = static_cast<std::uint8_t>(children.ranges[i].size());
      }
    }
    return node;
  }

  // False for a leaf.
  bool subtree(const BvhRange& range, Part& part) const {
    if (range.size() > parallel_size) {
      large(range, part);
      return true;
    }
    if (range.size() <= leaves_.most) return false;
    const auto both = halves(range);
    part.nodes.reserve(range.size() / 8 + 1);
    part.nodes.emplace_back();
    small(*both, part.nodes, 0);
    return true;
  }

  // Children by splitting in half, each half, and each of theirs, so that it can be done side by side.
  void open(const BvhRange& range, int levels, Children& children) const {
    const auto both = levels > 0 ? halves(range) : std::nullopt;
    if (!both) {
      children.add(range, levels > 0);
      return;
    }
    Children right;
    threads_.both([&] { open(both->left, levels - 1, children); },
                  [&] { open(both->right, levels - 1, right); });
    for (int i = 0; i < right.count; ++i) children.add(right.ranges[i], right.is_leaf[i]);
  }

  void large(const BvhRange& range, Part& part) const {
    Children children;
    open(range, 3, children);
    std::vector<Part> parts(static_cast<std::size_t>(children.count));
    parallel_each(threads_, 0, parts.size(), [&](std::size_t i) {
      if (!children.is_leaf[i]) children.is_leaf[i] = !subtree(children.ranges[i], parts[i]);
    });
    part.nodes.push_back(node_of(children));
    part.parts = std::move(parts);
  }

  // Children by splitting that with the largest surface until there are eight.
  void small(const BvhHalves& first, std::vector<BvhNode>& nodes, std::uint32_t index) const {
    Children children;
    children.add(first.left, false);
    children.add(first.right, false);
    float areas[bvh_width] = {first.left.box.half_area(), first.right.box.half_area()};
    while (children.count < bvh_width) {
      int widest = -1;
      for (int i = 0; i < children.count; ++i) {
        if (!children.is_leaf[i] && (widest < 0 || areas[i] > areas[widest])) widest = i;
      }
      if (widest < 0) break;
      const auto both = halves(children.ranges[widest]);
      if (!both) {
        children.is_leaf[widest] = true;
        continue;
      }
      children.ranges[widest] = both->left;
      areas[widest] = both->left.box.half_area();
      areas[children.count] = both->right.box.half_area();
      children.add(both->right, false);
    }
    std::optional<BvhHalves> below[bvh_width];
    for (int i = 0; i < children.count; ++i) {
      children.is_leaf[i] = children.is_leaf[i] || children.ranges[i].size() <= leaves_.most;
      if (!children.is_leaf[i]) below[i] = halves(children.ranges[i]);
    }
    BvhNode node = node_of(children);
    for (int i = 0; i < children.count; ++i) {
      if (!below[i]) continue;
      node.child[i] = static_cast<std::uint32_t>(nodes.size());
      nodes.emplace_back();
    }
    nodes[index] = node;
    for (int i = 0; i < children.count; ++i) {
      if (below[i]) small(*below[i], nodes, node.child[i]);
    }
  }

  static std::size_t size_of(const Part& part) {
    std::size_t result = part.nodes.size();
    for (const Part& below : part.parts) result += size_of(below);
    return result;
  }

  // Releases the memory of what it has appended.
  static void append(Part& part, std::vector<BvhNode>& nodes) {
    const auto base = static_cast<std::uint32_t>(nodes.size());
    for (BvhNode node : part.nodes) {
      for (int i = 0; i < bvh_width; ++i) {
        if (node.count[i] == 0 && node.child[i] != 0) node.child[i] += base;
      }
      nodes.push_back(node);
    }
    part.nodes = {};
    for (std::size_t i = 0; i < part.parts.size(); ++i) {
      if (part.parts[i].nodes.empty()) continue;
      nodes[base].child[i] = static_cast<std::uint32_t>(nodes.size());
      append(part.parts[i], nodes);
    }
  }

  std::span<BoxReference> references_;
  const LeafSizes& leaves_;
  ThreadBudget& threads_;
};

}  // namespace

BvhItems::BvhItems(const Bounds& all, std::size_t count) {
  if (!all.empty()) centre_ = 0.5 * all.min + 0.5 * all.max;
  if (!is_finite(centre_)) centre_ = Vec3(0);
  const double size = std::max(largest(all.min), largest(all.max));
  slack_ = static_cast<float>(0x1p-21 * largest(all.max - centre_) + 0x1p-40 * size);
  references_.reserve(count);
}

Bvh build_bvh(BvhItems items, const LeafSizes& leaves, ThreadBudget& threads) {
  Bvh result;
  result.centre = items.centre_;
  for (int axis = 0; axis < 3; ++axis) {
    result.centre_error[axis] = static_cast<float>(0x1p-44 * std::abs(result.centre[axis]));
  }
  result.slack = items.slack_;
  if (items.references_.empty()) return result;
  result.nodes = Builder(items.references_, leaves, threads).build();
  result.order.reserve(items.references_.size());
  for (const BoxReference& reference : items.references_) result.order.push_back(reference.item());
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
