// Elementary functions without branches or tables, which a compiler can apply to several numbers at once. The
// same number gives the same result on every machine: only additions, multiplications and divisions in IEEE
// single precision, never fused.
#pragma once

#include <bit>
#include <cstdint>

namespace trace {

// The logarithm to base 2 of x > 0 that is not denormal; absolute error below 3e-7 for x near 1, otherwise
// relative. x = 2^e m with m in [sqrt(1/2), sqrt(2)); ln m = 2 (s + s^3/3 + s^5/5 + ...), s = (m-1)/(m+1),
// where the first term left out is below 1e-9.
inline float fast_log2(float x) {
  constexpr std::int32_t root_half = 0x3f3504f3;
  const auto bits = std::bit_cast<std::int32_t>(x) - root_half;
  const float exponent = static_cast<float>(bits >> 23);
  const float m = std::bit_cast<float>((bits & 0x007fffff) + root_half);
  const float s = (m - 1) / (m + 1);
  const float t = s * s;
  const float series = 1 + t * (1.0F / 3 + t * (1.0F / 5 + t * (1.0F / 7 + t * (1.0F / 9))));
  return exponent + s * series * 2.88539008F;  // 2 / ln 2
}

// 2^x for -126 <= x <= 127; relative error below 3e-7. The Taylor series of e^y, |y| <= ln(2)/2, to y^7.
inline float fast_exp2(float x) {
  constexpr float no_fraction = 0x1.8p23F;
  const float whole = (x + no_fraction) - no_fraction;
  const float y = (x - whole) * 0.693147181F;
  const float series =
      1 + y * (1 + y * (1.0F / 2 +
                        y * (1.0F / 6 + y * (1.0F / 24 + y * (1.0F / 120 + y * (1.0F / 720 + y / 5040))))));
  return series * std::bit_cast<float>((static_cast<std::int32_t>(whole) + 127) << 23);
}

// x to the power p for x > 0 that is not denormal, where the result is neither denormal nor infinite.
inline float fast_pow(float x, float p) {
  return fast_exp2(p * fast_log2(x));
}

// The cube root of x > 0 that is not denormal; relative error below 3e-7. A third of the exponent (W. Kahan's
// first guess, off by 4 % at most), then two steps of Halley's method, each of which cubes the error.
inline float fast_cube_root(float x) {
  const float third = static_cast<float>(std::bit_cast<std::int32_t>(x)) * (1.0F / 3);
  float y = std::bit_cast<float>(static_cast<std::int32_t>(third) + 0x2a5137a0);
  for (int step = 0; step < 2; ++step) {
    const float cube = y * y * y;
    y = y * (cube + 2 * x) / (2 * cube + x);
  }
  return y;
}

}  // namespace trace
