// What a hierarchy is built from: a 32-bit box around each item, rounded outward, and the item's number.
#pragma once

#include <immintrin.h>

#include <bit>
#include <cstdint>

#include "geometry/bounds.hpp"

namespace trace {

// Boxes in 32 bits: x, y, z and a fourth that does not count. The high corner is kept negated, so that both
// corners grow by minima.
struct alignas(32) FloatBox {
  __m128 low, minus_high;  // not initialized

  static FloatBox empty() {
    const __m128 infinity = _mm_set1_ps(std::numeric_limits<float>::infinity());
    return {infinity, infinity};
  }

  __m128 high() const { return _mm_xor_ps(minus_high, _mm_set1_ps(-0.0f)); }

  // NaN in what is added leaves the box as it is.
  void add(const FloatBox& other) {
    low = _mm_min_ps(other.low, low);
    minus_high = _mm_min_ps(other.minus_high, minus_high);
  }

  float half_area() const {
    const __m128 d = _mm_add_ps(low, minus_high);  // minus the size
    const __m128 products = _mm_mul_ps(d, _mm_shuffle_ps(d, d, _MM_SHUFFLE(3, 0, 2, 1)));
    const __m128 second = _mm_shuffle_ps(products, products, _MM_SHUFFLE(1, 1, 1, 1));
    return _mm_cvtss_f32(_mm_add_ss(_mm_add_ss(products, second), _mm_movehl_ps(products, products)));
  }
};

// The fourth lane of the low corner is the item's number.
struct BoxReference {
  FloatBox box;

  std::uint32_t item() const {
    return static_cast<std::uint32_t>(
        _mm_cvtsi128_si32(_mm_shuffle_epi32(_mm_castps_si128(box.low), _MM_SHUFFLE(3, 3, 3, 3))));
  }
};

// Two doubles and one more: a place in space.
struct DoubleLanes {
  __m128d xy, z;  // the upper half of z does not count

  static DoubleLanes load(const Vec3& v) { return {_mm_loadu_pd(&v.x), _mm_load_sd(&v.z)}; }
};

inline DoubleLanes min(const DoubleLanes& a, const DoubleLanes& b) {
  return {_mm_min_pd(a.xy, b.xy), _mm_min_sd(a.z, b.z)};
}

inline DoubleLanes max(const DoubleLanes& a, const DoubleLanes& b) {
  return {_mm_max_pd(a.xy, b.xy), _mm_max_sd(a.z, b.z)};
}

// The largest floats that are not above.
inline __m128 rounded_down(const DoubleLanes& v) {
  const __m128 rounded = _mm_movelh_ps(_mm_cvtpd_ps(v.xy), _mm_cvtpd_ps(v.z));
  const __m128d above_xy = _mm_cmpgt_pd(_mm_cvtps_pd(rounded), v.xy);
  const __m128d above_z = _mm_cmpgt_pd(_mm_cvtps_pd(_mm_movehl_ps(rounded, rounded)), v.z);
  const __m128i above = _mm_castps_si128(
      _mm_shuffle_ps(_mm_castpd_ps(above_xy), _mm_castpd_ps(above_z), _MM_SHUFFLE(2, 0, 2, 0)));
  // The float below has the bits less one, or, under zero, plus one; that below zero the least of all.
  const __m128i bits = _mm_castps_si128(rounded);
  const __m128i minus = _mm_srai_epi32(bits, 31);
  const __m128i step = _mm_sub_epi32(_mm_set1_epi32(-1), _mm_add_epi32(minus, minus));
  const __m128i zero = _mm_castps_si128(_mm_cmpeq_ps(rounded, _mm_setzero_ps()));
  const __m128i below = _mm_or_si128(_mm_andnot_si128(zero, _mm_add_epi32(bits, step)),
                                     _mm_and_si128(zero, _mm_set1_epi32(std::bit_cast<int>(0x80000001u))));
  return _mm_castsi128_ps(_mm_or_si128(_mm_andnot_si128(above, bits), _mm_and_si128(above, below)));
}

// The tightest 32-bit box around [low, high] and some slack, relative to `centre`: the exact formulas work in
// the space of the object and hit up to its edge there, which the box misses by the rounding of the object's
// place, some 2^-50 of its largest coordinate.
inline BoxReference outward(std::uint32_t item, const DoubleLanes& low, const DoubleLanes& high,
                            const DoubleLanes& centre) {
  const __m128d sign = _mm_set1_pd(-0.0);
  const __m128d size_xy = _mm_max_pd(_mm_andnot_pd(sign, low.xy), _mm_andnot_pd(sign, high.xy));
  const __m128d size_z = _mm_max_sd(_mm_andnot_pd(sign, low.z), _mm_andnot_pd(sign, high.z));
  const __m128d largest = _mm_max_sd(_mm_max_sd(size_xy, _mm_unpackhi_pd(size_xy, size_xy)), size_z);
  const __m128d slack = _mm_mul_pd(_mm_set1_pd(0x1p-40), _mm_unpacklo_pd(largest, largest));
  const auto minus = [&](__m128d v) { return _mm_xor_pd(v, sign); };
  const DoubleLanes below{_mm_sub_pd(_mm_sub_pd(low.xy, centre.xy), slack),
                          _mm_sub_sd(_mm_sub_sd(low.z, centre.z), slack)};
  const DoubleLanes above{minus(_mm_add_pd(_mm_sub_pd(high.xy, centre.xy), slack)),
                          minus(_mm_add_sd(_mm_sub_sd(high.z, centre.z), slack))};
  const __m128 numbered = _mm_castsi128_ps(_mm_set_epi32(std::bit_cast<int>(item), 0, 0, 0));
  const __m128 xyz = _mm_castsi128_ps(_mm_set_epi32(0, -1, -1, -1));
  return {{_mm_or_ps(_mm_and_ps(xyz, rounded_down(below)), numbered), rounded_down(above)}};
}

}  // namespace trace
