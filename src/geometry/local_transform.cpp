#include "geometry/local_transform.hpp"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "geometry/rounding.hpp"
#include "geometry/unit_vector.hpp"

namespace trace {
namespace {

// The axis times a power of two where GLM's normalize would overflow or underflow; itself otherwise.
Vec3 of_moderate_size(const Vec3& axis) {
  const double size = largest(axis);
  if (!(size > 0) || (size > 0x1p-400 && size < 0x1p+400)) return axis;
  return unit_vector_of_any_size(axis).direction;
}

// The error of glm::rotate in each entry, for u = 2^-53. The cosine c and the sine s come from the library to
// within 1 ulp, which is at most u for a value below 1. A coordinate a_i of the normalised axis has a
// relative error of 4.5 u (3 roundings of the square of the length, halved by the root, then root, reciprocal
// and product). t_i = (1 - c) a_i adds two roundings and the error of c: u |a_i| + 6.5 u (1 - c) |a_i|. So
// t_i a_j is within u |a_i a_j| + 12 u (1 - c) |a_i a_j|, s a_k within u |a_k| + 5.5 u |s a_k|, and the sum
// rounds once more. |a_i a_j| <= 1/2 off the diagonal, all entries are at most 1: every entry is within
//   u (3 + 12 (1 - c) |a_i a_j| + 6 |s a_k|)
// where the 6 for 5.5 leaves room for terms in u^2; k is the third axis, absent on the diagonal.
Mat3 rotation_error(const Vec3& axis, double angle) {
  const Vec3 a = glm::normalize(axis);
  const double turn = 1 - std::cos(angle), s = std::abs(std::sin(angle));
  Mat3 error;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double third = i == j ? 0 : std::abs(a[3 - i - j]);
      error[i][j] = unit_roundoff * (3.0 + 12 * turn * std::abs(a[i] * a[j]) + 6 * s * third);
    }
  }
  return error;
}

}  // namespace

LocalTransform translation(const Vec3& offset) {
  LocalTransform t;
  t.matrix = glm::translate(Mat4(1), offset);
  t.inverse.value = glm::translate(Mat4(1), -offset);
  return t;
}

LocalTransform rotation(const Vec3& axis, double angle) {
  LocalTransform t;
  const Vec3 moderate = of_moderate_size(axis);
  t.matrix = glm::rotate(Mat4(1), angle, moderate);
  t.inverse.value = glm::transpose(t.matrix);
  const Mat3 error = rotation_error(moderate, angle);  // symmetric
  t.inverse.error = Mat4(error);
  t.inverse.error[3][3] = 0;
  // The exact rotation keeps lengths; a 3 x 3 matrix whose entries are at most e stretches by at most 3 e,
  // and no entry of `error` is above 33 u.
  t.inverse_stretch = 1 + 100 * unit_roundoff;
  return t;
}

LocalTransform scaling(const Vec3& factors) {
  LocalTransform t;
  t.matrix = glm::scale(Mat4(1), factors);
  const Vec3 inverse = 1.0 / factors;
  t.inverse.value = glm::scale(Mat4(1), inverse);
  for (int axis = 0; axis < 3; ++axis) {
    // Exact for powers of two; a result below the normal doubles is off by half the smallest.
    const bool exact = std::fma(factors[axis], inverse[axis], -1.0) == 0;
    const double size = std::abs(inverse[axis]);
    t.inverse.error[axis][axis] = exact ? 0 : unit_roundoff * size * (1 + 4 * unit_roundoff) + 0x1p-1074;
  }
  t.inverse_stretch = largest(inverse) * (1 + 4 * unit_roundoff);
  return t;
}

LocalTransform given_matrix(const Mat4& matrix) {
  LocalTransform t{matrix, bounded_inverse(matrix), 0};
  // The Frobenius norm is at least the spectral norm; times sqrt(9) for the largest entry alone.
  double size = 0;
  for (int column = 0; column < 3; ++column) size = std::max(size, largest(Vec3(t.inverse.value[column])));
  t.inverse_stretch = 3 * size * (1 + 4 * unit_roundoff);
  return t;
}

}  // namespace trace
