// A plain walk through the program's hierarchies (acceleration/bvh.hpp) in any kind of number.
//
// A box's planes are floats and so exact in T. The ray's origin relative to the hierarchy's centre c is off
// by u |c| + u |o - c|, and (plane - o) / d as a product with the reciprocal of d has three more roundings.
// What is to be found are hits by the primitives' formulas, in the space of the object, whose coordinates are
// off by some ten roundings of those of origin and hit. So planes are moved apart by 16 u (2 |c| + |o - c| +
// the largest |plane|), and distances are made smaller on entering and larger on leaving by 8 u. That loses
// no hit whose place is right to that; one that a formula finds further from its box is an error, which the
// boxes take away. A float needs the most room: at coordinates of 1000, 1/500 of a unit.
#pragma once

#include <array>

#include "acceleration/bvh.hpp"
#include "precision/ray.hpp"

namespace trace::precision {

template <class T>
class WalkedTree {
 public:
  explicit WalkedTree(const Bvh& bvh) : bvh_(&bvh), centre_(bvh.centre) {
    Vec3<T> largest_plane(0);
    if (!bvh.nodes.empty()) {
      const BvhNode& root = bvh.nodes[0];
      for (int child = 0; child < bvh_width; ++child) {
        if (root.child[child] == 0 && root.count[child] == 0) continue;
        for (int axis = 0; axis < 3; ++axis) {
          const float size = std::max(std::abs(root.low[axis][child]), std::abs(root.high[axis][child]));
          largest_plane[axis] = std::max(largest_plane[axis], static_cast<T>(size));
        }
      }
    }
    room_ = 16 * unit_roundoff<T> * (T(2) * glm::abs(centre_) + largest_plane);
    // In a grazing hit a small error across the ray is one along it up to the root of that.
    slack_ = 8 * root_of_roundoff<T>() * (largest_plane.x + largest_plane.y + largest_plane.z);
  }

  // Calls leaf(first, count, limit) for each leaf that the ray may touch within `limit`, near ones first. The
  // call returns the limit from then on; a negative number ends.
  template <class Leaf>
  void walk(const Ray<T>& ray, T limit, Leaf&& leaf) const;

 private:
  struct Slabs {
    Vec3<T> near_origin, far_origin, near_inverse, far_inverse;
    std::array<bool, 3> negative;
  };
  struct Entry {
    T t;
    std::uint32_t index, count;
  };

  Slabs slabs_of(const Ray<T>& ray) const;
  // Where each child of `node` is entered and left within `limit`. A product of 0 and infinity, of a ray in
  // the plane of a side, changes neither.
  static void meet(const BvhNode& node, const Slabs& slabs, T limit, std::array<T, bvh_width>& enter,
                   std::array<T, bvh_width>& leave);
  T with_slack(T limit) const { return limit * (1 + 8 * root_of_roundoff<T>()) + slack_; }

  const Bvh* bvh_;
  Vec3<T> centre_, room_;
  T slack_;
};

template <class T>
typename WalkedTree<T>::Slabs WalkedTree<T>::slabs_of(const Ray<T>& ray) const {
  Slabs result;
  const Vec3<T> origin = ray.origin - centre_;
  const T less = 1 - 8 * unit_roundoff<T>, more = 1 + 8 * unit_roundoff<T>;
  for (int axis = 0; axis < 3; ++axis) {
    const bool negative = std::signbit(ray.direction[axis]);
    const T apart = room_[axis] + 16 * unit_roundoff<T> * std::abs(origin[axis]);
    result.negative[static_cast<std::size_t>(axis)] = negative;
    result.near_origin[axis] = origin[axis] + (negative ? -apart : apart);
    result.far_origin[axis] = origin[axis] - (negative ? -apart : apart);
    const T inverse = 1 / ray.direction[axis];
    result.near_inverse[axis] = inverse * less;
    result.far_inverse[axis] = inverse * more;
  }
  return result;
}

template <class T>
void WalkedTree<T>::meet(const BvhNode& node, const Slabs& slabs, T limit, std::array<T, bvh_width>& enter,
                         std::array<T, bvh_width>& leave) {
  enter.fill(0);
  leave.fill(limit);
  for (int axis = 0; axis < 3; ++axis) {
    const bool negative = slabs.negative[static_cast<std::size_t>(axis)];
    const float* near = negative ? node.high[axis] : node.low[axis];
    const float* far = negative ? node.low[axis] : node.high[axis];
    for (std::size_t child = 0; child < bvh_width; ++child) {
      const T in = (static_cast<T>(near[child]) - slabs.near_origin[axis]) * slabs.near_inverse[axis];
      const T out = (static_cast<T>(far[child]) - slabs.far_origin[axis]) * slabs.far_inverse[axis];
      enter[child] = in > enter[child] ? in : enter[child];
      leave[child] = out < leave[child] ? out : leave[child];
    }
  }
}

template <class T>
template <class Leaf>
void WalkedTree<T>::walk(const Ray<T>& ray, T limit, Leaf&& leaf) const {
  if (bvh_->nodes.empty()) return;
  const Slabs slabs = slabs_of(ray);
  std::array<Entry, (bvh_width - 1) * max_bvh_depth + bvh_width> stack;
  std::size_t size = 0;
  Entry entry{0, 0, 0};
  T furthest = with_slack(limit);
  for (;;) {
    if (entry.count == 0) {
      const BvhNode& node = bvh_->nodes[entry.index];
      std::array<T, bvh_width> enter, leave;
      meet(node, slabs, furthest, enter, leave);
      // The nearest on top.
      const std::size_t base = size;
      for (std::size_t child = 0; child < bvh_width; ++child) {
        const bool exists = node.child[child] != 0 || node.count[child] != 0;
        if (!exists || !(enter[child] <= leave[child])) continue;
        const Entry next{enter[child], node.child[child], node.count[child]};
        std::size_t at = size++;
        for (; at > base && stack[at - 1].t < next.t; --at) stack[at] = stack[at - 1];
        stack[at] = next;
      }
    } else {
      limit = leaf(entry.index, entry.count, limit);
      if (limit < 0) return;
      furthest = with_slack(limit);
    }
    do {
      if (size == 0) return;
      entry = stack[--size];
    } while (entry.t > furthest);
  }
}

}  // namespace trace::precision
