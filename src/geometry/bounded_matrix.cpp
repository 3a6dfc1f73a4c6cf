#include "geometry/bounded_matrix.hpp"

#include <limits>

#include "geometry/rounding.hpp"

namespace trace {
namespace {

using Extended = long double;
using ExtendedMat4 = glm::mat<4, 4, Extended, glm::defaultp>;
using ExtendedVec4 = glm::vec<4, Extended, glm::defaultp>;

constexpr double smallest = std::numeric_limits<double>::denorm_min();
// Makes up for the roundings in computing a bound itself: positive terms, and far fewer than 64 of them.
constexpr double slack = 1 + 0x1p-47;

ExtendedMat4 absolute(ExtendedMat4 m) {
  for (int column = 0; column < 4; ++column) m[column] = glm::abs(m[column]);
  return m;
}

bool is_power_of_two(double x) {
  int exponent = 0;
  return std::abs(std::frexp(x, &exponent)) == 0.5;
}

// Rounded up.
double upwards(Extended bound) {
  return bound == 0 ? 0 : static_cast<double>(bound) * slack + smallest;
}

}  // namespace

Mat4 absolute(const Mat4& m) {
  return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2]), glm::abs(m[3])};
}

bool is_finite(const Mat4& m) {
  for (int column = 0; column < 4; ++column) {
    if (!is_finite(Vec3(m[column])) || !std::isfinite(m[column].w)) return false;
  }
  return true;
}

Mat4 product_rounding(const Mat4& a, const Mat4& b) {
  Mat4 bound(0);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      int terms = 0;
      bool exact_products = true;
      double size = 0;
      for (int k = 0; k < 4; ++k) {
        const double left = a[k][row], right = b[column][k];
        if (left == 0 || right == 0) continue;
        ++terms;
        size += std::abs(left * right);
        if (!is_power_of_two(left) && !is_power_of_two(right)) exact_products = false;
      }
      const int roundings = terms - 1 + (exact_products ? 0 : 1);
      if (terms > 0) bound[column][row] = gamma(roundings) * size * slack;
      // A product below the normal doubles is off by half the smallest.
      if (terms > 0 && size < 0x1p-960) bound[column][row] += terms * smallest;
    }
  }
  return bound;
}

// With x the computed inverse and G = x m - 1 the exact inverse is (1 + G)^-1 x, so that
//   |x - m^-1| <= (|G| + |G|^2 + ...) |x|.
// H >= |G| adds to the computed residual what its own rounding can be, 5 * 2^-64 |x| |m|. For y the size of
// what m yields, |m| 1, and w = |x| y let H w <= q w. Then |x|_ij <= w_i / y_j, and the terms beyond the
// first add up to at most q / (1 - q) (H w)_i / y_j.
BoundedMatrix bounded_inverse(const Mat4& m) {
  if (m == Mat4(1)) return {};
  const ExtendedMat4 exact(m);
  BoundedMatrix result;
  result.value = Mat4(glm::inverse(exact));
  for (int column = 0; column < 4; ++column)
    result.error[column] = Vec4(std::numeric_limits<double>::infinity());
  if (!is_finite(result.value)) return result;

  const ExtendedMat4 x(result.value);
  const ExtendedMat4 size_m = absolute(exact), size_x = absolute(x);
  const ExtendedMat4 h = absolute(x * exact - ExtendedMat4(1)) + Extended(5 * 0x1p-64) * (size_x * size_m);
  const ExtendedVec4 y = size_m * ExtendedVec4(1);
  const ExtendedVec4 w = size_x * y;
  const ExtendedVec4 hw = h * w;
  Extended q = 0;
  for (int row = 0; row < 4; ++row) {
    if (!(hw[row] <= w[row] / 2)) return result;
    q = glm::max(q, hw[row] / w[row]);
  }
  const ExtendedMat4 first = h * size_x;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      result.error[column][row] = upwards(first[column][row] + q / (1 - q) * hw[row] / y[column]);
    }
  }
  return result;
}

bool reliable(const BoundedMatrix& inverse, const Mat4& m) {
  if (!is_finite(m) || !is_finite(inverse.value)) return false;
  const ExtendedVec4 y = absolute(ExtendedMat4(m)) * ExtendedVec4(1);
  const ExtendedVec4 size = absolute(ExtendedMat4(inverse.value)) * y;
  const ExtendedVec4 error = ExtendedMat4(inverse.error) * y;
  for (int row = 0; row < 4; ++row) {
    if (!(size[row] > 0 && error[row] <= Extended(0x1p-20) * size[row])) return false;
  }
  return true;
}

}  // namespace trace
