#include "acceleration/mesh_kernels.hpp"

#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "acceleration/mesh_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "acceleration/triangle_filter-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, bvh_width>;
using Lanes = hn::Vec<Floats>;
constexpr std::size_t lanes = hn::MaxLanes(Floats());

HWY_INLINE unsigned bits_of(hn::Mask<Floats> mask) {
  std::uint8_t bits[8];
  hn::StoreMaskBits(Floats(), mask, bits);
  return bits[0];
}

// The ray in every lane.
struct LaneRay {
  Lanes near_origin[3], far_origin[3], near_inverse[3], far_inverse[3];
  std::size_t near_plane[3], far_plane[3];  // in floats from the start of a node
  Lanes origin[3], direction[3], reach;

  HWY_INLINE LaneRay(const BvhRay& ray, const FilterRay& filter) {
    const Floats d;
    for (int axis = 0; axis < 3; ++axis) {
      near_origin[axis] = hn::Set(d, ray.near_origin[axis]);
      far_origin[axis] = hn::Set(d, ray.far_origin[axis]);
      near_inverse[axis] = hn::Set(d, ray.near_inverse[axis]);
      far_inverse[axis] = hn::Set(d, ray.far_inverse[axis]);
      const std::size_t low = offsetof(BvhNode, low) / sizeof(float) + axis * bvh_width;
      const std::size_t high = offsetof(BvhNode, high) / sizeof(float) + axis * bvh_width;
      near_plane[axis] = ray.negative[axis] ? high : low;
      far_plane[axis] = ray.negative[axis] ? low : high;
      origin[axis] = hn::Set(d, filter.origin[axis]);
      direction[axis] = hn::Set(d, filter.direction[axis]);
    }
    reach = hn::Set(d, filter.reach);
  }
};

// A bit for each child whose box the ray meets up to `limit`, and where it enters them.
HWY_INLINE unsigned meets_boxes(const LaneRay& ray, const BvhNode& node, float limit, float* distance) {
  const Floats d;
  const float* planes = &node.low[0][0];
  unsigned bits = 0;
  for (std::size_t first = 0; first < bvh_width; first += lanes) {
    const auto near_at = [&](int axis) HWY_ATTR {
      const Lanes plane = hn::Load(d, planes + ray.near_plane[axis] + first);
      return hn::Mul(hn::Sub(plane, ray.near_origin[axis]), ray.near_inverse[axis]);
    };
    const auto far_at = [&](int axis) HWY_ATTR {
      const Lanes plane = hn::Load(d, planes + ray.far_plane[axis] + first);
      return hn::Mul(hn::Sub(plane, ray.far_origin[axis]), ray.far_inverse[axis]);
    };
    // Of x86's minimum and maximum NaN gives the second operand: an axis, or two, do not count then.
    const Lanes enter = hn::Max(hn::Max(near_at(0), near_at(1)), hn::Max(near_at(2), hn::Zero(d)));
    const Lanes leave = hn::Min(hn::Min(far_at(0), far_at(1)), hn::Min(far_at(2), hn::Set(d, limit)));
    hn::Store(enter, d, distance + first);
    bits |= bits_of(hn::Le(enter, leave)) << first;
  }
  return bits;
}

// A bit for each triangle of a leaf that the filter does not reject (triangle_filter.hpp).
HWY_INLINE unsigned meets_triangles(const LaneRay& ray, const float* filter, std::uint32_t count,
                                    float furthest) {
  const Floats d;
  const Lanes limit = hn::Set(d, furthest);
  unsigned bits = 0;
  for (std::size_t first = 0; first < bvh_width; first += lanes) {
    if (first >= count) break;
    const auto run = [&](std::size_t i) HWY_ATTR { return hn::LoadU(d, filter + i * count + first); };
    const Lanes corner[3] = {run(0), run(1), run(2)};
    const Lanes ab[3] = {run(3), run(4), run(5)}, ac[3] = {run(6), run(7), run(8)};
    bits |= bits_of(may_meet(d, ray.origin, ray.direction, ray.reach, limit, corner, ab, ac, run(9)))
            << first;
  }
  return bits & ((1u << count) - 1);
}

// A child to be visited.
struct Entry {
  float t;  // where the ray enters it
  std::uint32_t index;
  std::uint32_t count;
};

// The children of one node that are to be visited.
struct Children {
  const BvhNode& node;
  alignas(32) float distance[bvh_width];
  unsigned bits;

  HWY_INLINE Children(const LaneRay& ray, const BvhNode& visited, float limit) : node(visited) {
    bits = meets_boxes(ray, node, limit, distance);
  }
  HWY_INLINE Entry take() {
    const int i = __builtin_ctz(bits);
    bits &= bits - 1;
    return {distance[i], node.child[i], node.count[i]};
  }
};

// The nearest; the others go on the stack, near ones on top. Branches, not selections: what they foretell is
// fetched ahead.
HWY_INLINE Entry nearest_of(Children& children, Entry*& top) {
  Entry first = children.take();
  const Entry* const base = top;
  while (children.bits != 0) {
    Entry next = children.take();
    if (next.t < first.t) std::swap(next, first);
    Entry* at = top++;
    for (; at > base && at[-1].t < next.t; --at) *at = at[-1];
    *at = next;
  }
  return first;
}

// Any; the others go on the stack.
HWY_INLINE Entry any_of(Children& children, Entry*& top) {
  const Entry first = children.take();
  while (children.bits != 0) *top++ = children.take();
  return first;
}

template <bool in_order, class Search>
HWY_INLINE void search_mesh(const MeshTree& tree, const Ray& world, double limit, Search& search) {
  const Bvh& bvh = tree.bvh();
  if (bvh.nodes.empty()) return;
  const FilterRay filter(bvh.centre, world, search.reach());
  const BvhRay box_ray(bvh, world);
  if (!box_ray.is_plain()) return one_by_one(tree, box_ray, limit, search);
  const LaneRay ray(box_ray, filter);
  const BvhNode* nodes = bvh.nodes.data();
  const float* triangles = tree.filter().values.data();
  // A visit takes one entry and adds at most eight.
  Entry stack[(bvh_width - 1) * max_bvh_depth + bvh_width];
  Entry* top = stack;
  Entry entry{0, 0, 0};
  float box_limit = upper_limit(bvh, limit), furthest = filter.furthest(limit);
  for (;;) {
    while (entry.count == 0) {
      Children children(ray, nodes[entry.index], box_limit);
      if (children.bits == 0) goto next;
      entry = in_order ? nearest_of(children, top) : any_of(children, top);
    }
    {
      const std::uint32_t first = entry.index;
      unsigned bits = meets_triangles(ray, triangles + TriangleFilter::floats * first, entry.count, furthest);
      if (bits != 0) {
        do {
          limit = search.test(first + static_cast<std::uint32_t>(__builtin_ctz(bits)), limit);
          if (limit < 0) return;
          bits &= bits - 1;
        } while (bits != 0);
        box_limit = upper_limit(bvh, limit);
        furthest = filter.furthest(limit);
      }
    }
  next:
    do {
      if (top == stack) return;
      entry = *--top;
    } while (entry.t > box_limit);
  }
}

void nearest(const MeshTree& tree, const Ray& ray, double limit, NearestFace& search) {
  search_mesh<true>(tree, ray, limit, search);
}

void any(const MeshTree& tree, const Ray& ray, double limit, AnyFace& search) {
  search_mesh<false>(tree, ray, limit, search);
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace trace {
namespace {

void nearest(const MeshTree& tree, const Ray& ray, double limit, NearestFace& search) {
  one_by_one(tree, BvhRay(tree.bvh(), ray), limit, search);
}

void any(const MeshTree& tree, const Ray& ray, double limit, AnyFace& search) {
  one_by_one(tree, BvhRay(tree.bvh(), ray), limit, search);
}

constexpr MeshKernels kernels[] = {{nearest, any},
                                   {N_SSE4::nearest, N_SSE4::any},
                                   {N_AVX2::nearest, N_AVX2::any},
                                   {N_AVX3::nearest, N_AVX3::any}};

}  // namespace

const MeshKernels& mesh_kernels(InstructionSet set) {
  return kernels[static_cast<std::size_t>(set)];
}

}  // namespace trace
#endif
