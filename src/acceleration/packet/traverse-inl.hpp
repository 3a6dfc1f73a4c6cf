// A packet of rays through a hierarchy.
//
// Boxes are tested twice, conservatively both times. All eight of a node at once against one ray that stands
// for the packet: of every number that bvh.hpp's test of a box uses it has the lane's that comes in earliest
// or goes out latest (the rounding of floats keeps their order), so a box that it misses is missed by all.
// Then, when a box's turn comes, the rays of the packet side by side against that box, with what is known of
// nearer hits by then. Rays whose directions differ in a sign are taken apart first.
#if defined(TRACE_ACCELERATION_PACKET_TRAVERSE_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_ACCELERATION_PACKET_TRAVERSE_INL_HPP
#undef TRACE_ACCELERATION_PACKET_TRAVERSE_INL_HPP
#else
#define TRACE_ACCELERATION_PACKET_TRAVERSE_INL_HPP
#endif

#include <array>

#include "acceleration/bvh.hpp"
#include "geometry/packet/rays-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

using FloatTag = hn::ScalableTag<float>;  // as many lanes as Numbers
using Floats = hn::Vec<FloatTag>;
using BoxTag = hn::CappedTag<float, static_cast<std::size_t>(bvh_width)>;

HWY_INLINE Floats floats_of(const Numbers& n) {
  const hn::Half<FloatTag> h;
  return hn::Combine(FloatTag(), hn::DemoteTo(h, n.high), hn::DemoteTo(h, n.low));
}
HWY_INLINE unsigned bits_of(const hn::Mask<FloatTag>& m) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(FloatTag(), m, bytes);
  return bytes[0] | static_cast<unsigned>(bytes[1]) << 8;
}

HWY_INLINE float smallest_float(Floats v) {
  return hn::GetLane(hn::MinOfLanes(FloatTag(), v));
}
HWY_INLINE float largest_float(Floats v) {
  return hn::GetLane(hn::MaxOfLanes(FloatTag(), v));
}

// As BvhRay, for the rays of a packet and for the one that stands for them.
class PacketRays {
 public:
  // `some` are lanes whose directions have the same signs, at least one.
  HWY_INLINE PacketRays(const Bvh& bvh, const Rays& rays, const Mask& some) {
    const Numbers* const origin[3] = {&rays.origin.x, &rays.origin.y, &rays.origin.z};
    const Numbers* const direction[3] = {&rays.direction.x, &rays.direction.y, &rays.direction.z};
    const std::size_t first = first_lane(bits_of(some));
    const FloatTag f;
    for (int axis = 0; axis < 3; ++axis) {
      // Lanes that do not count get the numbers of one that does.
      const Numbers d = select(some, *direction[axis], lane(*direction[axis], first));
      const Numbers o = select(some, *origin[axis], lane(*origin[axis], first)) - Numbers(bvh.centre[axis]);
      const Floats from = floats_of(o), along = floats_of(d);
      const Floats error = hn::Add(hn::Mul(hn::Set(f, 0x1p-22f), hn::Abs(from)),
                                   hn::Set(f, bvh.centre_error[static_cast<std::size_t>(axis)]));
      const Floats apart = hn::CopySign(error, along);
      const Floats inverse = hn::Div(hn::Set(f, 1.0f), along);
      near_origin_[axis] = hn::Add(from, apart);
      far_origin_[axis] = hn::Sub(from, apart);
      near_inverse_[axis] = hn::Mul(inverse, hn::Set(f, 1 - 0x1p-21f));
      far_inverse_[axis] = hn::Mul(inverse, hn::Set(f, 1 + 0x1p-21f));
      negative_[axis] = hn::GetLane(hn::CopySign(hn::Set(f, 1.0f), along)) < 0;
      const bool down = negative_[axis];
      all_near_origin_[axis] = down ? smallest_float(near_origin_[axis]) : largest_float(near_origin_[axis]);
      all_far_origin_[axis] = down ? largest_float(far_origin_[axis]) : smallest_float(far_origin_[axis]);
      all_near_inverse_[axis] =
          down ? largest_float(near_inverse_[axis]) : smallest_float(near_inverse_[axis]);
      all_far_inverse_[axis] = down ? smallest_float(far_inverse_[axis]) : largest_float(far_inverse_[axis]);
    }
  }

  // Which boxes of a node any ray may touch within `limit`, and from where on.
  HWY_INLINE unsigned touch_any(const BvhNode& node, float limit, float (&enter_at)[bvh_width]) const {
    const BoxTag b;
    unsigned result = 0;
    for (std::size_t i = 0; i < std::size_t{bvh_width}; i += hn::Lanes(b)) {
      auto enter = hn::Zero(b), leave = hn::Set(b, limit);
      for (int axis = 0; axis < 3; ++axis) {
        const float* near = negative_[axis] ? node.high[axis] : node.low[axis];
        const float* far = negative_[axis] ? node.low[axis] : node.high[axis];
        enter = hn::Max(hn::Mul(hn::Sub(hn::Load(b, near + i), hn::Set(b, all_near_origin_[axis])),
                                hn::Set(b, all_near_inverse_[axis])),
                        enter);
        leave = hn::Min(hn::Mul(hn::Sub(hn::Load(b, far + i), hn::Set(b, all_far_origin_[axis])),
                                hn::Set(b, all_far_inverse_[axis])),
                        leave);
      }
      hn::StoreU(enter, b, enter_at + i);
      std::uint8_t bytes[8] = {};
      hn::StoreMaskBits(b, hn::Le(enter, leave), bytes);
      result |= static_cast<unsigned>(bytes[0]) << i;
    }
    return result;
  }

  // Which rays may touch one box within their limits.
  HWY_INLINE unsigned touch(const BvhNode& node, std::size_t child, Floats limit) const {
    const FloatTag f;
    Floats enter = hn::Zero(f), leave = limit;
    for (int axis = 0; axis < 3; ++axis) {
      const float near = negative_[axis] ? node.high[axis][child] : node.low[axis][child];
      const float far = negative_[axis] ? node.low[axis][child] : node.high[axis][child];
      enter = hn::Max(hn::Mul(hn::Sub(hn::Set(f, near), near_origin_[axis]), near_inverse_[axis]), enter);
      leave = hn::Min(hn::Mul(hn::Sub(hn::Set(f, far), far_origin_[axis]), far_inverse_[axis]), leave);
    }
    return bits_of(hn::Le(enter, leave));
  }

 private:
  Floats near_origin_[3], far_origin_[3], near_inverse_[3], far_inverse_[3];
  float all_near_origin_[3], all_far_origin_[3], all_near_inverse_[3], all_far_inverse_[3];
  bool negative_[3];
};

// upper_limit() of bvh.hpp; for lanes that do not count a negative number.
HWY_INLINE Floats upper_limits(const Bvh& bvh, const Numbers& limit, unsigned some) {
  const FloatTag f;
  const Numbers wide = select(mask_of(some), limit * (1 + 0x1p-20), -1.0);
  const Floats narrow = floats_of(wide);
  return hn::IfThenElse(hn::Lt(narrow, hn::Zero(f)), narrow, hn::Add(narrow, hn::Set(f, bvh.slack)));
}

// So many nodes, 2 MB, stay in a cache near the processor; of more those to be visited are fetched ahead.
inline constexpr std::size_t nodes_nearby = 1 << 13;

HWY_INLINE void fetch_ahead(const void* from, std::size_t bytes) {
  constexpr std::size_t cache_line = 64;
  const char* const at = static_cast<const char*>(from);
  for (std::size_t i = 0; i < bytes; i += cache_line) __builtin_prefetch(at + i);
}

// Calls leaf.visit(first, count, lanes) for each leaf that some lanes may touch within the limits that
// leaf.limits() has at the time; near ones first as far as boxes tell. It returns whether limits() or
// going(), the lanes that want to go on, have changed. Leaves that may be visited are told to leaf.foresee()
// before. `some` are lanes whose directions have the same signs.
template <class Leaf>
HWY_INLINE void traverse_alike(const Bvh& bvh, const Rays& rays, unsigned some, Leaf& leaf) {
  struct Entry {
    float t;
    std::uint32_t node;
    std::uint32_t child;
  };
  std::array<Entry, (bvh_width - 1) * max_bvh_depth + bvh_width> stack;
  const PacketRays packet(bvh, rays, mask_of(some));
  const bool is_far = bvh.nodes.size() > nodes_nearby;
  unsigned going = some;
  Floats limits = upper_limits(bvh, leaf.limits(), going);
  float furthest = largest_float(limits);

  std::size_t size = 0;
  std::uint32_t index = 0;
  for (;;) {
    {
      const BvhNode& node = bvh.nodes[index];
      alignas(32) float enter[bvh_width];
      unsigned touched = packet.touch_any(node, furthest, enter);
      const std::size_t base = size;
      while (touched != 0) {
        const auto child = static_cast<std::uint32_t>(__builtin_ctz(touched));
        touched &= touched - 1;
        if (node.child[child] == 0 && node.count[child] == 0) continue;  // none; but NaN passes its box
        const Entry next{enter[child], index, child};
        if (is_far) {
          if (node.count[child] == 0) {
            fetch_ahead(&bvh.nodes[node.child[child]], sizeof(BvhNode));
          } else {
            leaf.foresee(node.child[child], node.count[child]);
          }
        }
        std::size_t at = size++;
        for (; at > base && stack[at - 1].t < next.t; --at) stack[at] = stack[at - 1];
        stack[at] = next;
      }
    }
    for (;;) {
      if (size == 0) return;
      const Entry entry = stack[--size];
      if (entry.t > furthest) continue;
      const BvhNode& node = bvh.nodes[entry.node];
      const unsigned touching = packet.touch(node, entry.child, limits) & going;
      if (touching == 0) continue;
      if (node.count[entry.child] == 0) {
        index = node.child[entry.child];
        break;
      }
      if (!leaf.visit(node.child[entry.child], node.count[entry.child], touching)) continue;
      going = leaf.going() & some;
      if (going == 0) return;
      limits = upper_limits(bvh, leaf.limits(), going);
      furthest = largest_float(limits);
    }
  }
}

// The same for any lanes.
template <class Leaf>
HWY_INLINE void traverse(const Bvh& bvh, const Rays& rays, const Mask& active, Leaf& leaf) {
  if (bvh.nodes.empty()) return;
  const unsigned signs[3] = {bits_of(is_negative(rays.direction.x)), bits_of(is_negative(rays.direction.y)),
                             bits_of(is_negative(rays.direction.z))};
  for (unsigned left = bits_of(active); left != 0;) {
    const std::size_t first = first_lane(left);
    unsigned alike = left;
    for (const unsigned sign : signs) alike &= (sign >> first & 1) != 0 ? sign : ~sign;
    left &= ~alike;
    traverse_alike(bvh, rays, alike, leaf);
  }
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
