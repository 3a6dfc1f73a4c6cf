#include "scene/sample_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trace {

Vec2 multi_jittered(int n, int k) {
  const int column = k % n, row = k / n;
  const double size = n;
  return {(column + (row + 0.5) / size) / size, (row + (column + 0.5) / size) / size};
}

double radical_inverse(std::uint32_t k) {
  std::uint32_t reversed = 0;
  for (int bit = 0; bit < 32; ++bit) reversed |= (k >> bit & 1u) << (31 - bit);
  return (reversed + 0.5) / 0x1p32;
}

Vec2 on_disc(const Vec2& s) {
  const Vec2 p = 2.0 * s - Vec2(1);
  if (p.x == 0 && p.y == 0) return p;
  const bool wide = std::abs(p.x) > std::abs(p.y);
  const double radius = wide ? p.x : p.y;
  const double angle =
      wide ? std::numbers::pi / 4 * (p.y / p.x) : std::numbers::pi / 2 - std::numbers::pi / 4 * (p.x / p.y);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Vec3 on_sphere(const Vec2& s) {
  const double z = 1 - 2 * s.x, around = 2 * std::numbers::pi * s.y;
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  return {r * std::cos(around), r * std::sin(around), z};
}

// With r = sin a the part within is (2 / pi) (a - sin a cos a), which grows with a from 0 to 1 at pi / 2.
double radius_of_even_disc(double part) {
  double low = 0, high = std::numbers::pi / 2;
  for (int step = 0; step < 60; ++step) {
    const double a = (low + high) / 2;
    (2 / std::numbers::pi * (a - std::sin(a) * std::cos(a)) < part ? low : high) = a;
  }
  return std::sin((low + high) / 2);
}

}  // namespace trace
