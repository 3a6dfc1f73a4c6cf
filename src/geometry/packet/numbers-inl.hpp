// Numbers side by side: one double for each ray of a packet.
//
// The operators round each lane as those of double do, so a formula written with them has the bits of the
// same formula in doubles. Kernels are compiled once for each set of instructions, which decides how many
// lanes there are (Highway: every source that includes this does so through hwy/foreach_target.h).
#if defined(TRACE_GEOMETRY_PACKET_NUMBERS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_GEOMETRY_PACKET_NUMBERS_INL_HPP
#undef TRACE_GEOMETRY_PACKET_NUMBERS_INL_HPP
#else
#define TRACE_GEOMETRY_PACKET_NUMBERS_INL_HPP
#endif

#include <cmath>
#include <cstddef>

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::ScalableTag<double>;
inline constexpr std::size_t lanes = HWY_LANES(double);

// Which lanes a statement is about.
struct Mask {
  hn::Mask<Tag> lanes;
};

HWY_INLINE Mask operator&(const Mask& a, const Mask& b) {
  return {hn::And(a.lanes, b.lanes)};
}
HWY_INLINE Mask operator|(const Mask& a, const Mask& b) {
  return {hn::Or(a.lanes, b.lanes)};
}
HWY_INLINE Mask operator!(const Mask& a) {
  return {hn::Not(a.lanes)};
}
HWY_INLINE Mask& operator&=(Mask& a, const Mask& b) {
  return a = a & b;
}
HWY_INLINE Mask& operator|=(Mask& a, const Mask& b) {
  return a = a | b;
}
// a & !b
HWY_INLINE Mask without(const Mask& a, const Mask& b) {
  return {hn::AndNot(b.lanes, a.lanes)};
}

HWY_INLINE bool none(const Mask& m) {
  return hn::AllFalse(Tag(), m.lanes);
}
HWY_INLINE bool any(const Mask& m) {
  return !none(m);
}
HWY_INLINE std::size_t count(const Mask& m) {
  return hn::CountTrue(Tag(), m.lanes);
}
HWY_INLINE Mask first_lanes(std::size_t n) {
  return {hn::FirstN(Tag(), n)};
}
HWY_INLINE Mask no_lanes() {
  return first_lanes(0);
}

// Lane i is bit i.
HWY_INLINE unsigned bits_of(const Mask& m) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Tag(), m.lanes, bytes);
  return bytes[0];
}
HWY_INLINE Mask mask_of(unsigned bits) {
  const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits)};
  return {hn::LoadMaskBits(Tag(), bytes)};
}

struct Numbers {
  hn::Vec<Tag> v;

  Numbers() = default;
  HWY_INLINE Numbers(hn::Vec<Tag> value) : v(value) {}            // NOLINT
  HWY_INLINE Numbers(double value) : v(hn::Set(Tag(), value)) {}  // NOLINT: the same in all lanes
};

HWY_INLINE Numbers operator+(const Numbers& a, const Numbers& b) {
  return hn::Add(a.v, b.v);
}
HWY_INLINE Numbers operator-(const Numbers& a, const Numbers& b) {
  return hn::Sub(a.v, b.v);
}
HWY_INLINE Numbers operator*(const Numbers& a, const Numbers& b) {
  return hn::Mul(a.v, b.v);
}
HWY_INLINE Numbers operator/(const Numbers& a, const Numbers& b) {
  return hn::Div(a.v, b.v);
}
HWY_INLINE Numbers operator-(const Numbers& a) {
  return hn::Neg(a.v);
}
HWY_INLINE Numbers& operator+=(Numbers& a, const Numbers& b) {
  return a = a + b;
}
HWY_INLINE Numbers& operator-=(Numbers& a, const Numbers& b) {
  return a = a - b;
}

HWY_INLINE Mask operator<(const Numbers& a, const Numbers& b) {
  return {hn::Lt(a.v, b.v)};
}
HWY_INLINE Mask operator<=(const Numbers& a, const Numbers& b) {
  return {hn::Le(a.v, b.v)};
}
HWY_INLINE Mask operator>(const Numbers& a, const Numbers& b) {
  return {hn::Gt(a.v, b.v)};
}
HWY_INLINE Mask operator>=(const Numbers& a, const Numbers& b) {
  return {hn::Ge(a.v, b.v)};
}
HWY_INLINE Mask operator==(const Numbers& a, const Numbers& b) {
  return {hn::Eq(a.v, b.v)};
}

HWY_INLINE Numbers sqrt(const Numbers& a) {
  return hn::Sqrt(a.v);
}
HWY_INLINE Numbers abs(const Numbers& a) {
  return hn::Abs(a.v);
}
HWY_INLINE Numbers select(const Mask& m, const Numbers& yes, const Numbers& no) {
  return hn::IfThenElse(m.lanes, yes.v, no.v);
}
// The number or zero.
HWY_INLINE Numbers where(const Mask& m, const Numbers& yes) {
  return hn::IfThenElseZero(m.lanes, yes.v);
}

// As std::max and std::min: the first operand where neither is larger, and where one is not a number.
HWY_INLINE Numbers greater_of(const Numbers& a, const Numbers& b) {
  return select(a < b, b, a);
}
HWY_INLINE Numbers lesser_of(const Numbers& a, const Numbers& b) {
  return select(b < a, b, a);
}

// a b + c rounded once, as std::fma.
HWY_INLINE Numbers fused(const Numbers& a, const Numbers& b, const Numbers& c) {
#if HWY_TARGET == HWY_SSE4
  HWY_ALIGN double x[lanes], y[lanes], z[lanes];
  hn::Store(a.v, Tag(), x);
  hn::Store(b.v, Tag(), y);
  hn::Store(c.v, Tag(), z);
  for (std::size_t i = 0; i < lanes; ++i) z[i] = std::fma(x[i], y[i], z[i]);
  return hn::Load(Tag(), z);
#else
  return hn::MulAdd(a.v, b.v, c.v);
#endif
}

// Numbers lane by lane, for what has no vector form.
struct Lanes {
  HWY_ALIGN double at[lanes];

  Lanes() = default;
  HWY_INLINE explicit Lanes(const Numbers& n) { hn::Store(n.v, Tag(), at); }
  HWY_INLINE Numbers numbers() const { return hn::Load(Tag(), at); }
};

// One lane. Slow; of several, better by Lanes.
HWY_INLINE double lane(const Numbers& n, std::size_t i) {
  return Lanes(n).at[i];
}

// The largest of some lanes, at least `least`.
HWY_INLINE double largest_lane(const Mask& m, const Numbers& n, double least) {
  return hn::GetLane(hn::MaxOfLanes(Tag(), select(m, n, least).v));
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
