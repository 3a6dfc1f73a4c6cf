// Matrices of 113 bits: the exact placements that those in doubles are judged by.
#pragma once

#include <array>

#include "geometry/vector.hpp"
#include "tests/support/quad.hpp"

namespace trace::test {

// By their series; the angle within 10, so that cancellation costs no more than 5 of the 34 digits.
inline void sine_and_cosine(double angle, Quad& sine, Quad& cosine) {
  Quad term = 1;
  sine = cosine = 0;
  for (int n = 0; n < 120; ++n) {
    (n % 2 == 0 ? cosine : sine) += n % 4 < 2 ? term : -term;
    term *= Quad(angle) / (n + 1);
  }
}

struct QuadMatrix {
  std::array<std::array<Quad, 4>, 4> rows{};

  QuadMatrix() {
    for (std::size_t i = 0; i < 4; ++i) rows[i][i] = 1;
  }
  explicit QuadMatrix(const Mat4& m) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) rows[i][j] = m[static_cast<int>(j)][static_cast<int>(i)];
    }
  }

  friend QuadMatrix operator*(const QuadMatrix& a, const QuadMatrix& b) {
    QuadMatrix result;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        result.rows[i][j] = 0;
        for (std::size_t k = 0; k < 4; ++k) result.rows[i][j] += a.rows[i][k] * b.rows[k][j];
      }
    }
    return result;
  }

  // Of a point (w = 1) or a direction (w = 0).
  std::array<Quad, 3> times(const Vec3& v, double w) const {
    std::array<Quad, 3> result;
    for (std::size_t i = 0; i < 3; ++i) {
      result[i] = rows[i][0] * v.x + rows[i][1] * v.y + rows[i][2] * v.z + rows[i][3] * w;
    }
    return result;
  }
};

// A transform and its inverse, both exact to more than 100 bits.
struct QuadTransform {
  QuadMatrix matrix, inverse;

  static QuadTransform translation(const Vec3& t) {
    QuadTransform q;
    for (std::size_t i = 0; i < 3; ++i) {
      q.matrix.rows[i][3] = t[static_cast<int>(i)];
      q.inverse.rows[i][3] = -t[static_cast<int>(i)];
    }
    return q;
  }

  static QuadTransform scaling(const Vec3& s) {
    QuadTransform q;
    for (std::size_t i = 0; i < 3; ++i) {
      q.matrix.rows[i][i] = s[static_cast<int>(i)];
      q.inverse.rows[i][i] = 1 / Quad(s[static_cast<int>(i)]);
    }
    return q;
  }

  static QuadTransform rotation(const Vec3& axis, double angle) {
    const std::array<Quad, 3> v{axis.x, axis.y, axis.z};
    const Quad length = root(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    Quad sine, cosine;
    sine_and_cosine(angle, sine, cosine);
    QuadTransform q;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        Quad entry = v[i] * v[j] / (length * length) * (1 - cosine);
        if (i == j) entry += cosine;
        if (i != j) entry += ((j + 3 - i) % 3 == 1 ? -sine : sine) * v[3 - i - j] / length;
        q.matrix.rows[i][j] = q.inverse.rows[j][i] = entry;
      }
    }
    return q;
  }

  QuadTransform inside(const QuadTransform& local) const {
    QuadTransform q;
    q.matrix = matrix * local.matrix;
    q.inverse = local.inverse * inverse;
    return q;
  }
};

}  // namespace trace::test
