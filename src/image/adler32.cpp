#include "image/adler32.hpp"

#include <emmintrin.h>

#include <algorithm>
#include <cstddef>

namespace trace {
namespace {

constexpr std::uint32_t base = 65521;  // the largest prime below 2^16
constexpr std::size_t lanes = 16;
// Groups of `lanes` bytes whose weighted sum stays far below 2^31 in each lane: a group adds at most 255 *
// (16 + 15 + 8 + 7).
constexpr std::size_t most_groups = 4096;

// a: 1 and all bytes; b: all values that a took.
struct Sums {
  std::uint64_t a = 1, b = 0;

  void add(std::uint8_t byte) {
    a += byte;
    b += a;
  }
  void add_groups(const std::uint8_t* bytes, std::size_t groups);
  void reduce() {
    a %= base;
    b %= base;
  }
};

std::uint64_t sum_of_halves(__m128i v) {
  return static_cast<std::uint64_t>(_mm_cvtsi128_si64(v)) +
         static_cast<std::uint64_t>(_mm_cvtsi128_si64(_mm_unpackhi_epi64(v, v)));
}

// Byte j of a group is counted in b 16 - j times for its place in the group, and 16 times for each group
// behind it. SSE2, which every x86-64 has.
void Sums::add_groups(const std::uint8_t* bytes, std::size_t groups) {
  const __m128i zero = _mm_setzero_si128();
  const __m128i weights_low = _mm_set_epi16(9, 10, 11, 12, 13, 14, 15, 16);
  const __m128i weights_high = _mm_set_epi16(1, 2, 3, 4, 5, 6, 7, 8);
  __m128i sum = zero, sums_before = zero, weighted = zero;
  for (std::size_t k = 0; k < groups; ++k) {
    const __m128i group = _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes + k * lanes));
    sums_before = _mm_add_epi64(sums_before, sum);
    sum = _mm_add_epi64(sum, _mm_sad_epu8(group, zero));
    const __m128i low = _mm_madd_epi16(_mm_unpacklo_epi8(group, zero), weights_low);
    const __m128i high = _mm_madd_epi16(_mm_unpackhi_epi8(group, zero), weights_high);
    weighted = _mm_add_epi32(weighted, _mm_add_epi32(low, high));
  }
  const __m128i weighted_halves =
      _mm_add_epi64(_mm_unpacklo_epi32(weighted, zero), _mm_unpackhi_epi32(weighted, zero));
  b += groups * lanes * a + lanes * sum_of_halves(sums_before) + sum_of_halves(weighted_halves);
  a += sum_of_halves(sum);
  reduce();
}

}  // namespace

std::uint32_t adler32_of(std::span<const std::uint8_t> bytes) {
  Sums sums;
  while (bytes.size() >= lanes) {
    const std::size_t groups = std::min(most_groups, bytes.size() / lanes);
    sums.add_groups(bytes.data(), groups);
    bytes = bytes.subspan(groups * lanes);
  }
  for (const std::uint8_t byte : bytes) sums.add(byte);
  sums.reduce();
  return static_cast<std::uint32_t>(sums.b << 16 | sums.a);
}

}  // namespace trace
