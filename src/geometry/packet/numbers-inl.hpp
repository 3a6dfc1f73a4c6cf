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
using Register = hn::Vec<Tag>;
using RegisterMask = hn::Mask<Tag>;
// Two registers of doubles stand side by side: as many lanes as a register has floats, in which boxes are
// tested, and while one waits for a quotient or a root the other goes on.
inline constexpr std::size_t half = HWY_LANES(double), lanes = 2 * half;

// Which lanes a statement is about.
struct Mask {
  RegisterMask low, high;
};

HWY_INLINE Mask operator&(const Mask& a, const Mask& b) {
  return {hn::And(a.low, b.low), hn::And(a.high, b.high)};
}
HWY_INLINE Mask operator|(const Mask& a, const Mask& b) {
  return {hn::Or(a.low, b.low), hn::Or(a.high, b.high)};
}
HWY_INLINE Mask operator!(const Mask& a) {
  return {hn::Not(a.low), hn::Not(a.high)};
}
HWY_INLINE Mask& operator&=(Mask& a, const Mask& b) {
  return a = a & b;
}
HWY_INLINE Mask& operator|=(Mask& a, const Mask& b) {
  return a = a | b;
}
// a & !b
HWY_INLINE Mask without(const Mask& a, const Mask& b) {
  return {hn::AndNot(b.low, a.low), hn::AndNot(b.high, a.high)};
}

HWY_INLINE bool none(const Mask& m) {
  return hn::AllFalse(Tag(), hn::Or(m.low, m.high));
}
HWY_INLINE bool any(const Mask& m) {
  return !none(m);
}
HWY_INLINE std::size_t count(const Mask& m) {
  return hn::CountTrue(Tag(), m.low) + hn::CountTrue(Tag(), m.high);
}
HWY_INLINE Mask first_lanes(std::size_t n) {
  return {hn::FirstN(Tag(), n), hn::FirstN(Tag(), n > half ? n - half : 0)};
}
HWY_INLINE Mask no_lanes() {
  return first_lanes(0);
}

// Lane i is bit i.
HWY_INLINE unsigned bits_of(const Mask& m) {
  std::uint8_t low[8] = {}, high[8] = {};
  hn::StoreMaskBits(Tag(), m.low, low);
  hn::StoreMaskBits(Tag(), m.high, high);
  return low[0] | static_cast<unsigned>(high[0]) << half;
}
// The lanes of a mask one after another: for (const std::size_t i : each_lane(bits)).
struct each_lane {
  unsigned bits;

  struct Place {
    unsigned left;
    HWY_INLINE std::size_t operator*() const { return static_cast<std::size_t>(__builtin_ctz(left)); }
    HWY_INLINE Place& operator++() {
      left &= left - 1;
      return *this;
    }
    HWY_INLINE bool operator!=(const Place& other) const { return left != other.left; }
  };
  HWY_INLINE explicit each_lane(unsigned lane_bits) : bits(lane_bits) {}
  HWY_INLINE explicit each_lane(const Mask& m) : bits(bits_of(m)) {}
  HWY_INLINE Place begin() const { return {bits}; }
  HWY_INLINE Place end() const { return {0}; }
};
HWY_INLINE std::size_t first_lane(unsigned bits) {
  return *each_lane(bits).begin();
}

HWY_INLINE Mask mask_of(unsigned bits) {
  const std::uint8_t low[8] = {static_cast<std::uint8_t>(bits)};
  const std::uint8_t high[8] = {static_cast<std::uint8_t>(bits >> half)};
  return {hn::LoadMaskBits(Tag(), low), hn::LoadMaskBits(Tag(), high)};
}

struct Numbers {
  Register low, high;

  Numbers() = default;
  HWY_INLINE Numbers(const Register& l, const Register& h) : low(l), high(h) {}
  HWY_INLINE Numbers(double value)  // NOLINT: the same in all lanes
      : low(hn::Set(Tag(), value)), high(low) {}
};

HWY_INLINE Numbers operator+(const Numbers& a, const Numbers& b) {
  return {hn::Add(a.low, b.low), hn::Add(a.high, b.high)};
}
HWY_INLINE Numbers operator-(const Numbers& a, const Numbers& b) {
  return {hn::Sub(a.low, b.low), hn::Sub(a.high, b.high)};
}
HWY_INLINE Numbers operator*(const Numbers& a, const Numbers& b) {
  return {hn::Mul(a.low, b.low), hn::Mul(a.high, b.high)};
}
HWY_INLINE Numbers operator/(const Numbers& a, const Numbers& b) {
  return {hn::Div(a.low, b.low), hn::Div(a.high, b.high)};
}
HWY_INLINE Numbers operator-(const Numbers& a) {
  return {hn::Neg(a.low), hn::Neg(a.high)};
}
HWY_INLINE Numbers& operator+=(Numbers& a, const Numbers& b) {
  return a = a + b;
}
HWY_INLINE Numbers& operator-=(Numbers& a, const Numbers& b) {
  return a = a - b;
}

HWY_INLINE Mask operator<(const Numbers& a, const Numbers& b) {
  return {hn::Lt(a.low, b.low), hn::Lt(a.high, b.high)};
}
HWY_INLINE Mask operator<=(const Numbers& a, const Numbers& b) {
  return {hn::Le(a.low, b.low), hn::Le(a.high, b.high)};
}
HWY_INLINE Mask operator>(const Numbers& a, const Numbers& b) {
  return {hn::Gt(a.low, b.low), hn::Gt(a.high, b.high)};
}
HWY_INLINE Mask operator>=(const Numbers& a, const Numbers& b) {
  return {hn::Ge(a.low, b.low), hn::Ge(a.high, b.high)};
}
HWY_INLINE Mask operator==(const Numbers& a, const Numbers& b) {
  return {hn::Eq(a.low, b.low), hn::Eq(a.high, b.high)};
}

HWY_INLINE Numbers sqrt(const Numbers& a) {
  return {hn::Sqrt(a.low), hn::Sqrt(a.high)};
}
HWY_INLINE Numbers abs(const Numbers& a) {
  return {hn::Abs(a.low), hn::Abs(a.high)};
}
HWY_INLINE Numbers select(const Mask& m, const Numbers& yes, const Numbers& no) {
  return {hn::IfThenElse(m.low, yes.low, no.low), hn::IfThenElse(m.high, yes.high, no.high)};
}
HWY_INLINE Mask select(const Mask& m, const Mask& yes, const Mask& no) {
  return (m & yes) | without(no, m);
}
// The number or zero.
HWY_INLINE Numbers where(const Mask& m, const Numbers& yes) {
  return {hn::IfThenElseZero(m.low, yes.low), hn::IfThenElseZero(m.high, yes.high)};
}
// Whether the sign bit is set, that of -0 too.
HWY_INLINE Mask is_negative(const Numbers& n) {
  const Register one = hn::Set(Tag(), 1.0), zero = hn::Zero(Tag());
  return {hn::Lt(hn::CopySign(one, n.low), zero), hn::Lt(hn::CopySign(one, n.high), zero)};
}

// As std::max and std::min: the first operand where neither is larger, and where one is not a number.
HWY_INLINE Numbers greater_of(const Numbers& a, const Numbers& b) {
  return select(a < b, b, a);
}
HWY_INLINE Numbers lesser_of(const Numbers& a, const Numbers& b) {
  return select(b < a, b, a);
}

// In one instruction each; where a lane is not a number or both are zero, either of them.
HWY_INLINE Numbers greatest(const Numbers& a, const Numbers& b) {
  return {hn::Max(a.low, b.low), hn::Max(a.high, b.high)};
}
HWY_INLINE Numbers least(const Numbers& a, const Numbers& b) {
  return {hn::Min(a.low, b.low), hn::Min(a.high, b.high)};
}

// Numbers lane by lane, for what has no vector form.
struct Lanes {
  HWY_ALIGN double at[lanes];

  Lanes() = default;
  HWY_INLINE explicit Lanes(const Numbers& n) {
    hn::Store(n.low, Tag(), at);
    hn::Store(n.high, Tag(), at + half);
  }
  HWY_INLINE Numbers numbers() const { return {hn::Load(Tag(), at), hn::Load(Tag(), at + half)}; }
};

// a b + c rounded once, as std::fma.
HWY_INLINE Numbers fused(const Numbers& a, const Numbers& b, const Numbers& c) {
#if HWY_TARGET == HWY_SSE4
  const Lanes x(a), y(b);
  Lanes z(c);
  for (std::size_t i = 0; i < lanes; ++i) z.at[i] = std::fma(x.at[i], y.at[i], z.at[i]);
  return z.numbers();
#else
  return {hn::MulAdd(a.low, b.low, c.low), hn::MulAdd(a.high, b.high, c.high)};
#endif
}

// One lane. Slow; of several, better by Lanes.
HWY_INLINE double lane(const Numbers& n, std::size_t i) {
  return Lanes(n).at[i];
}

// Numbers in memory, aligned as Lanes are.
HWY_INLINE Numbers load(const double* from) {
  return {hn::Load(Tag(), from), hn::Load(Tag(), from + half)};
}
HWY_INLINE void store(const Numbers& n, double* to) {
  hn::Store(n.low, Tag(), to);
  hn::Store(n.high, Tag(), to + half);
}

// The largest of some lanes, at least `least`.
HWY_INLINE double largest_lane(const Mask& m, const Numbers& n, double least) {
  const Numbers counted = select(m, n, least);
  return hn::GetLane(hn::MaxOfLanes(Tag(), hn::Max(counted.low, counted.high)));
}
HWY_INLINE double sum_of_lanes(const Numbers& n) {
  return hn::GetLane(hn::SumOfLanes(Tag(), hn::Add(n.low, n.high)));
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
