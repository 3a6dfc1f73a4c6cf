// Bounding-volume hierarchy with eight children a node, over any kind of item that has a box.
//
// It only rejects: every item whose box the ray may touch is handed to the caller, who decides with the exact
// formulas. Boxes are 32-bit and rounded outward, and the ray's side of the test carries its own error bound
// (below), so a hit that testing every item would find is never lost.
#pragma once

#include <immintrin.h>

#include <array>
#include <cstdint>
#include <limits>

#include "acceleration/large_vector.hpp"
#include "geometry/bounds.hpp"

namespace trace {

inline constexpr int bvh_width = 8;

// Children that exist come first. Of the others low > high, and both child and count are 0, which no child
// that exists has: a box test that NaN passes has to look.
struct alignas(64) BvhNode {
  float low[3][bvh_width], high[3][bvh_width];  // axis, child
  std::uint32_t child[bvh_width];               // index of a node, or of the first item of a leaf
  std::uint8_t count[bvh_width];                // items in the leaf; 0 for a node
};

struct Bvh {
  LargeVector<BvhNode> nodes;        // the root is nodes[0]; empty where there are no items
  LargeVector<std::uint32_t> order;  // items in the order of the leaves
  Vec3 centre{0};  // boxes are relative to it, so that they are tight wherever the items are
  std::array<float, 4> centre_error{};  // 2^-44 of its coordinates
  float slack = 0;                      // by which a hit's t may come out too small (see upper_limit)
};

// Of the lists that it holds.
inline std::size_t bytes_of(const Bvh& bvh) {
  return bvh.nodes.size() * sizeof(BvhNode) + bvh.order.size() * sizeof(std::uint32_t);
}

// The surface-area heuristic's estimate of the work for a ray that meets the root: the sum over all nodes of
// their surface, and over all leaves of their surface times their items, in units of the root's surface. A
// node with its eight boxes counts as much as one item, or as one block of items where a search tests so many
// at once. 0 without nodes or where the root has no surface.
double surface_area_cost(const Bvh& bvh, unsigned block = 1);

// Binary splits above any node are at most so many; deeper ranges are halved by count, which adds at most 32
// levels. A node's children are at least one split below it.
inline constexpr int max_sah_depth = 64;
inline constexpr int max_bvh_depth = max_sah_depth + 32;

// The ray as the boxes see it.
//
// In exact arithmetic a slab is met at (plane - o) / d, o relative to the centre c of the hierarchy. Here o
// is rounded to float (error <= 2^-24 |o|) and the difference and product round again. The planes are
// therefore moved apart by e = 2^-22 |o| + 2^-44 |c|, which covers the first with room for the rounding of
// hits themselves (double, some 2^-50 of the coordinates before they were made relative), and the inverse is
// made smaller for entering and larger for leaving by 2^-21, which covers the six roundings (6 * 2^-24) that
// are relative to the distance (Ize, "Robust BVH Ray Traversal", JCGT 2(2) 2013). d = 0, of either sign,
// gives an infinite inverse: the slab is then all or nothing, and 0 * inf = NaN, a ray within a boundary
// plane, passes because the minimum and maximum below keep the other operand.
struct BvhRay {
  alignas(16) float near_origin[4], far_origin[4];
  alignas(16) float near_inverse[4], far_inverse[4];
  bool negative[3];

  BvhRay(const Bvh& bvh, const Ray& ray) {
    const Vec3 relative = ray.origin - bvh.centre;
    const __m128 sign = _mm_set1_ps(-0.0f);
    const __m128 origin = _mm_setr_ps(static_cast<float>(relative.x), static_cast<float>(relative.y),
                                      static_cast<float>(relative.z), 0);
    const __m128 direction =
        _mm_setr_ps(static_cast<float>(ray.direction.x), static_cast<float>(ray.direction.y),
                    static_cast<float>(ray.direction.z), 1);
    const __m128 error = _mm_add_ps(_mm_mul_ps(_mm_set1_ps(0x1p-22f), _mm_andnot_ps(sign, origin)),
                                    _mm_loadu_ps(bvh.centre_error.data()));
    // Apart: back where the ray goes up.
    const __m128 apart = _mm_or_ps(error, _mm_and_ps(sign, direction));
    const __m128 inverse = _mm_div_ps(_mm_set1_ps(1), direction);
    _mm_store_ps(near_origin, _mm_add_ps(origin, apart));
    _mm_store_ps(far_origin, _mm_sub_ps(origin, apart));
    _mm_store_ps(near_inverse, _mm_mul_ps(inverse, _mm_set1_ps(1 - 0x1p-21f)));
    _mm_store_ps(far_inverse, _mm_mul_ps(inverse, _mm_set1_ps(1 + 0x1p-21f)));
    const int signs = _mm_movemask_ps(direction);
    for (int axis = 0; axis < 3; ++axis) negative[axis] = (signs >> axis & 1) != 0;
  }

  // Whether boxes that do not exist are sure to be missed: the origin is in the range of
  // floats and the direction is a number.
  bool is_plain() const {
    const __m128 zero = _mm_setzero_ps();
    const __m128 size = _mm_andnot_ps(_mm_set1_ps(-0.0f), _mm_load_ps(near_inverse));
    const __m128 near_finite = _mm_cmpeq_ps(_mm_mul_ps(_mm_load_ps(near_origin), zero), zero);
    const __m128 far_finite = _mm_cmpeq_ps(_mm_mul_ps(_mm_load_ps(far_origin), zero), zero);
    return (_mm_movemask_ps(_mm_and_ps(_mm_and_ps(near_finite, far_finite), _mm_cmplt_ps(zero, size))) & 7) ==
           7;
  }
};

// A distance in double as an upper limit for boxes. Boxes may be off by the relative error above, and the t
// of a hit by more than its place: in a grazing hit a small error across becomes a large one along the ray,
// for a quadric up to the square root of 2^-50 of its size, for a triangle 2^-23 of its size and of t
// (geometry/triangle.hpp).
inline float upper_limit(const Bvh& bvh, double t) {
  return static_cast<float>(t * (1 + 0x1p-20)) + bvh.slack;
}

namespace detail {

// Four of a node's children against a ray: where it enters them, and a bit for each that it meets.
struct BoxTest {
  __m128 near_o[3], far_o[3], near_i[3], far_i[3];
  bool negative[3];

  explicit BoxTest(const BvhRay& ray) {
    for (int axis = 0; axis < 3; ++axis) {
      near_o[axis] = _mm_set1_ps(ray.near_origin[axis]);
      far_o[axis] = _mm_set1_ps(ray.far_origin[axis]);
      near_i[axis] = _mm_set1_ps(ray.near_inverse[axis]);
      far_i[axis] = _mm_set1_ps(ray.far_inverse[axis]);
      negative[axis] = ray.negative[axis];
    }
  }

  unsigned operator()(const BvhNode& node, int first, float limit, float* distance) const {
    __m128 enter = _mm_setzero_ps(), leave = _mm_set1_ps(limit);
    for (int axis = 0; axis < 3; ++axis) {
      const __m128 low = _mm_load_ps(node.low[axis] + first), high = _mm_load_ps(node.high[axis] + first);
      const __m128 near_plane = negative[axis] ? high : low, far_plane = negative[axis] ? low : high;
      enter = _mm_max_ps(_mm_mul_ps(_mm_sub_ps(near_plane, near_o[axis]), near_i[axis]), enter);
      leave = _mm_min_ps(_mm_mul_ps(_mm_sub_ps(far_plane, far_o[axis]), far_i[axis]), leave);
    }
    _mm_store_ps(distance, enter);
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(enter, leave)));
  }
};

}  // namespace detail

// Calls leaf(first, count, limit) for each leaf that the ray may touch within `limit`, near ones first as far
// as boxes tell. `first` counts in Bvh::order. The call returns the limit from then on: unchanged, the t of a
// nearer hit, or a negative number to end.
template <class Leaf>
void traverse(const Bvh& bvh, const BvhRay& ray, double limit, Leaf&& leaf) {
  if (bvh.nodes.empty()) return;
  struct Entry {
    float t;
    std::uint32_t index;
    std::uint32_t count;
  };
  // A visit takes one entry and adds at most eight.
  std::array<Entry, (bvh_width - 1) * max_bvh_depth + bvh_width> stack;
  std::size_t size = 0;
  Entry entry{0, 0, 0};
  float limit_f = upper_limit(bvh, limit);
  const detail::BoxTest test(ray);

  for (;;) {
    if (entry.count == 0) {
      const BvhNode& node = bvh.nodes[entry.index];
      alignas(16) float distance[bvh_width];
      unsigned mask = test(node, 0, limit_f, distance) | test(node, 4, limit_f, distance + 4) << 4;
      // Children go on the stack with the nearest on top.
      const std::size_t base = size;
      while (mask != 0) {
        const int child = __builtin_ctz(mask);
        mask &= mask - 1;
        if (node.child[child] == 0 && node.count[child] == 0) continue;  // none; but NaN passes its box
        const Entry next{distance[child], node.child[child], node.count[child]};
        std::size_t at = size++;
        for (; at > base && stack[at - 1].t < next.t; --at) stack[at] = stack[at - 1];
        stack[at] = next;
      }
    } else {
      limit = leaf(entry.index, entry.count, limit);
      if (limit < 0) return;
      limit_f = upper_limit(bvh, limit);
    }
    do {
      if (size == 0) return;
      entry = stack[--size];
    } while (entry.t > limit_f);
  }
}

}  // namespace trace
