#include <algorithm>
#include <numeric>

#include "acceleration/bvh.hpp"
#include "geometry/rounding.hpp"
#include "parallel/parallel.hpp"

namespace trace {
namespace {

struct Box3f {
  std::array<float, 3> low{inf, inf, inf}, high{-inf, -inf, -inf};
  static constexpr float inf = std::numeric_limits<float>::infinity();

  void add(const Box3f& b) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], b.low[axis]);
      high[axis] = std::max(high[axis], b.high[axis]);
    }
  }
  float half_area() const {
    const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x * y + y * z + z * x;
  }
};

double largest_coordinate(const Bounds& b) {
  return std::max(largest(b.min), largest(b.max));
}

// The tightest 32-bit box around `b` and some slack, relative to `centre`: the exact formulas work in the
// space of the object and hit up to its edge there, which the box misses by the rounding of the object's
// place, some 2^-50 of its largest coordinate.
Box3f rounded_outward(const Bounds& b, const Vec3& centre) {
  const double slack = 0x1p-40 * largest_coordinate(b);
  Box3f result;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = b.min[axis] - centre[axis] - slack, high = b.max[axis] - centre[axis] + slack;
    result.low[axis] = static_cast<float>(low);
    if (result.low[axis] > low) result.low[axis] = std::nextafter(result.low[axis], -Box3f::inf);
    result.high[axis] = static_cast<float>(high);
    if (result.high[axis] < high) result.high[axis] = std::nextafter(result.high[axis], Box3f::inf);
  }
  return result;
}

struct BinaryNode {
  Box3f box;
  std::uint32_t first, count;  // items; count is 0 for an inner node
  std::uint32_t left, right;
};

constexpr int bin_count = 16;
constexpr float traversal_cost = 1.0f;  // of one node, in units of one item's test
constexpr std::uint32_t parallel_size = 8192;

class Builder {
 public:
  Builder(std::span<const Bounds> items, std::uint32_t max_leaf) : max_leaf_(max_leaf) {
    Bounds all;
    for (const Bounds& b : items) all.add(b);
    if (!all.empty()) centre_ = 0.5 * all.min + 0.5 * all.max;
    if (!is_finite(centre_)) centre_ = Vec3(0);
    slack_ = static_cast<float>(0x1p-21 * largest(all.max - centre_) + 0x1p-40 * largest_coordinate(all));
    boxes_.reserve(items.size());
    for (const Bounds& b : items) boxes_.push_back(rounded_outward(b, centre_));
    order_.resize(items.size());
    std::iota(order_.begin(), order_.end(), 0u);
    if (!items.empty()) nodes_.resize(2 * items.size() - 1);
  }

  Bvh build() {
    Bvh result;
    if (nodes_.empty()) return result;
    const auto count = static_cast<std::uint32_t>(order_.size());
    split(0, 0, count, 0);
    result.nodes.reserve(order_.size() / 3 + 1);
    collapse(result);
    result.order = std::move(order_);
    result.centre = centre_;
    for (int axis = 0; axis < 3; ++axis) {
      result.centre_error[axis] = static_cast<float>(0x1p-44 * std::abs(centre_[axis]));
    }
    result.slack = slack_;
    return result;
  }

 private:
  float centre(std::uint32_t item, int axis) const {
    const float c = 0.5f * boxes_[item].low[axis] + 0.5f * boxes_[item].high[axis];
    return std::isfinite(c) ? c : 0.0f;
  }

  // The subtree of n items takes the 2n - 1 nodes from `node` on, so that halves can be built side by side
  // and the result does not depend on how they ran.
  void split(std::uint32_t node, std::uint32_t first, std::uint32_t last, int depth) {
    BinaryNode& n = nodes_[node];
    n.box = {};
    for (std::uint32_t i = first; i < last; ++i) n.box.add(boxes_[order_[i]]);
    n.first = first;
    n.count = last - first;
    const std::uint32_t middle = choose_split(n, first, last, depth);
    if (middle == last) return;  // a leaf
    n.count = 0;
    n.left = node + 1;
    n.right = node + 2 * (middle - first);
    if (last - first >= parallel_size) {
      threads_.both([=, this] { split(nodes_[node].left, first, middle, depth + 1); },
                    [=, this] { split(nodes_[node].right, middle, last, depth + 1); });
    } else {
      split(n.left, first, middle, depth + 1);
      split(n.right, middle, last, depth + 1);
    }
  }

  struct Plane {
    float cost = std::numeric_limits<float>::infinity();
    int axis = -1;
    int bin = 0;
  };

  // Reorders [first, last) and returns where the right half begins; `last` for a leaf.
  std::uint32_t choose_split(const BinaryNode& n, std::uint32_t first, std::uint32_t last, int depth) {
    const std::uint32_t count = last - first;
    if (count == 1) return last;
    Box3f centres;
    for (std::uint32_t i = first; i < last; ++i) {
      Box3f c;
      for (int axis = 0; axis < 3; ++axis) c.low[axis] = c.high[axis] = centre(order_[i], axis);
      centres.add(c);
    }
    const Plane plane = depth < max_sah_depth ? best_plane(centres, first, last) : Plane{};
    const float area = n.box.half_area();
    const float leaf_cost = static_cast<float>(count);
    const float split_cost = area > 0 ? traversal_cost + plane.cost / area : traversal_cost;
    if (count <= max_leaf_ && !(split_cost < leaf_cost)) return last;
    if (plane.axis >= 0) {
      const auto left = [&](std::uint32_t item) { return bin_of(item, plane.axis, centres) <= plane.bin; };
      const auto middle = std::partition(order_.begin() + first, order_.begin() + last, left);
      return static_cast<std::uint32_t>(middle - order_.begin());
    }
    // No plane separates the centres, or the tree is deep: halve by count.
    return first + count / 2;
  }

  int bin_of(std::uint32_t item, int axis, const Box3f& centres) const {
    const float low = centres.low[axis], high = centres.high[axis];
    const float scaled = static_cast<float>(bin_count) * ((centre(item, axis) - low) / (high - low));
    return scaled >= bin_count ? bin_count - 1 : (scaled > 0 ? static_cast<int>(scaled) : 0);
  }

  Plane best_plane(const Box3f& centres, std::uint32_t first, std::uint32_t last) const {
    Plane best;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(centres.high[axis] > centres.low[axis])) continue;
      std::array<Box3f, bin_count> boxes;
      std::array<std::uint32_t, bin_count> counts{};
      for (std::uint32_t i = first; i < last; ++i) {
        const int bin = bin_of(order_[i], axis, centres);
        boxes[bin].add(boxes_[order_[i]]);
        ++counts[bin];
      }
      std::array<float, bin_count> right_cost{};
      Box3f box;
      std::uint32_t count = 0;
      for (int bin = bin_count - 1; bin > 0; --bin) {
        box.add(boxes[bin]);
        count += counts[bin];
        right_cost[bin] = count == 0 ? -1 : box.half_area() * static_cast<float>(count);
      }
      box = {};
      count = 0;
      for (int bin = 0; bin + 1 < bin_count; ++bin) {
        box.add(boxes[bin]);
        count += counts[bin];
        if (count == 0 || right_cost[bin + 1] < 0) continue;
        const float cost = box.half_area() * static_cast<float>(count) + right_cost[bin + 1];
        if (cost < best.cost) best = {cost, axis, bin};
      }
    }
    return best;
  }

  // --- two children a node to four ---

  void collapse(Bvh& result) const {
    struct Task {
      std::uint32_t binary, wide;
    };
    std::vector<Task> tasks{{0, 0}};
    result.nodes.emplace_back();
    while (!tasks.empty()) {
      const Task task = tasks.back();
      tasks.pop_back();
      std::array<std::uint32_t, 4> children{task.binary};
      int count = 1;
      // Open the largest inner child until there are four.
      for (;;) {
        int widest = -1;
        for (int i = 0; i < count; ++i) {
          if (nodes_[children[i]].count != 0) continue;
          if (widest < 0 || nodes_[children[i]].box.half_area() > nodes_[children[widest]].box.half_area()) {
            widest = i;
          }
        }
        if (widest < 0 || count == 4) break;
        const BinaryNode& opened = nodes_[children[widest]];
        children[widest] = opened.left;
        children[count++] = opened.right;
      }
      for (int i = 0; i < 4; ++i) {
        const BinaryNode* child = i < count ? &nodes_[children[i]] : nullptr;
        std::uint32_t index = 0;
        if (child && child->count == 0) {
          index = static_cast<std::uint32_t>(result.nodes.size());
          result.nodes.emplace_back();
          tasks.push_back({children[i], index});
        }
        BvhNode& node = result.nodes[task.wide];
        for (int axis = 0; axis < 3; ++axis) {
          node.low[axis][i] = child ? child->box.low[axis] : Box3f::inf;
          node.high[axis][i] = child ? child->box.high[axis] : -Box3f::inf;
        }
        node.child[i] = child ? (child->count == 0 ? index : child->first) : 0;
        node.count[i] = child ? static_cast<std::uint8_t>(child->count) : 0;
      }
    }
  }

  ThreadBudget threads_{hardware_threads()};
  std::uint32_t max_leaf_;
  Vec3 centre_{0};
  float slack_ = 0;
  std::vector<Box3f> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<BinaryNode> nodes_;
};

}  // namespace

Bvh build_bvh(std::span<const Bounds> items, std::uint32_t max_leaf) {
  return Builder(items, max_leaf).build();
}

}  // namespace trace
