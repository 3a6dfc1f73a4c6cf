// The colour spaces of FLIP, from linear light as sRGB's primaries have it.
//
// X, Y and Z are those of CIE 1931 divided by those of white (D65). YCxCz (Flohr et al. 1993) is then
// (116 y - 16, 500 (x - y), 200 (y - z)), and as the filters add up to 1 they can be applied to the three
// differences Opponent without their factors.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "comparison/perceptual/vector_math.hpp"

namespace trace {

struct LinearRgb {
  float r, g, b;
};

struct Xyz {
  float x, y, z;  // of white: 1
};

struct Opponent {
  float y, red_green, blue_yellow;  // y, x - y, y - z
};

// CIE L*a*b* with a* and b* scaled down where it is dark (Hunt 1952): a* 0.01 L*, b* 0.01 L*.
struct HuntLab {
  float l, a, b;
};

namespace flip_matrices {

using Matrix = std::array<std::array<double, 3>, 3>;

// IEC 61966-2-1's primaries in exact fractions, as the authors' program has them.
inline constexpr Matrix rgb_to_xyz{{{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                                    {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                                    {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

constexpr Matrix with_white_1(Matrix m) {
  for (auto& row : m) {
    const double white = row[0] + row[1] + row[2];
    for (double& value : row) value /= white;
  }
  return m;
}

constexpr Matrix inverse(const Matrix& m) {
  const auto cofactor = [&m](std::size_t r, std::size_t c) {
    const std::size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
    return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
  };
  const double determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  Matrix result{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) result[r][c] = cofactor(c, r) / determinant;
  return result;
}

inline constexpr Matrix to_xyz = with_white_1(rgb_to_xyz);
inline constexpr Matrix to_rgb = inverse(to_xyz);

template <std::size_t row>
inline float product(const Matrix& m, float a, float b, float c) {
  return static_cast<float>(m[row][0]) * a + static_cast<float>(m[row][1]) * b +
         static_cast<float>(m[row][2]) * c;
}

}  // namespace flip_matrices

inline Xyz to_xyz(const LinearRgb& c) {
  using namespace flip_matrices;
  return {product<0>(flip_matrices::to_xyz, c.r, c.g, c.b), product<1>(flip_matrices::to_xyz, c.r, c.g, c.b),
          product<2>(flip_matrices::to_xyz, c.r, c.g, c.b)};
}

inline Opponent to_opponent(const LinearRgb& color) {
  const Xyz c = to_xyz(color);
  return {c.y, c.x - c.y, c.y - c.z};
}

// With what no screen can show clamped.
inline LinearRgb to_linear_rgb(const Opponent& color) {
  using namespace flip_matrices;
  const float x = color.red_green + color.y, y = color.y, z = color.y - color.blue_yellow;
  const auto clamped = [](float value) {
    const float above = value > 0 ? value : 0;
    return above < 1 ? above : 1.0F;
  };
  return {clamped(product<0>(to_rgb, x, y, z)), clamped(product<1>(to_rgb, x, y, z)),
          clamped(product<2>(to_rgb, x, y, z))};
}

// CIE 15's cube root, straight near 0.
inline float lab_root(float t) {
  constexpr float delta = 6.0F / 29;
  constexpr float least = delta * delta * delta;
  const float root = fast_cube_root(t > least ? t : least);
  const float line = t * (1 / (3 * delta * delta)) + 4.0F / 29;
  return t > least ? root : line;
}

inline HuntLab to_hunt_lab(const LinearRgb& color) {
  const Xyz c = to_xyz(color);
  const float x = lab_root(c.x), y = lab_root(c.y), z = lab_root(c.z);
  const float l = 116 * y - 16;
  return {l, 0.01F * l * (500 * (x - y)), 0.01F * l * (200 * (y - z))};
}

// The distance HyAB (Abasi, Tehran and Fairchild 2019).
inline float hyab(const HuntLab& p, const HuntLab& q) {
  const float a = p.a - q.a, b = p.b - q.b;
  return std::abs(p.l - q.l) + std::sqrt(a * a + b * b);
}

}  // namespace trace
