#include "geometry/frame.hpp"

#include <algorithm>

#include "geometry/normal_matrix.hpp"

namespace trace {
namespace {

// GLM's product of a matrix and a vector is (m0 x + m1 y) + (m2 z + m3 w), so a term of it is rounded at most
// three times: as a product, and in two sums. Sums with 0 and products with a power of two are exact.
int roundings(const Mat4& m, int row) {
  int terms = 0, products = 0, exponent = 0;
  for (int column = 0; column < 4; ++column) {
    if (m[column][row] == 0) continue;
    ++terms;
    if (column < 3 && std::abs(std::frexp(m[column][row], &exponent)) != 0.5) products = 1;
  }
  return std::clamp(terms - 1, 0, 2) + products;
}

double row_sum(const Mat4& m, int row) {
  return std::abs(m[0][row]) + std::abs(m[1][row]) + std::abs(m[2][row]);
}

double stretch(const Mat4& m) {
  double most = 0;
  for (int row = 0; row < 3; ++row) most = std::max(most, row_sum(m, row));
  return most * (1 + 4 * unit_roundoff);
}

// Whether each coordinate of the points of the placed unit cube is the same to 2^-40 of what it is summed
// from.
bool agrees(const Mat4& inverse, const Mat4& reference, const Mat4& placement) {
  if (!is_finite(inverse)) return false;
  const Vec4 y = absolute(placement) * Vec4(1);
  const Vec4 off = absolute(inverse - reference) * y, size = absolute(reference) * y;
  for (int row = 0; row < 4; ++row) {
    if (!(off[row] <= 0x1p-40 * size[row])) return false;
  }
  return true;
}

}  // namespace

Frame::Frame(const Placement& placement)
    : to_world(placement.to_world()),
      to_object(glm::inverse(placement.to_world())),
      normal_to_world(normal_matrix(placement.to_world())) {
  // Where the bound of the composed inverse says nothing, what the place is has been lost in its matrix, and
  // the matrix is taken for the place.
  const BoundedMatrix reference = placement.reliable() ? placement.to_object() : bounded_inverse(to_world);
  invertible_ = reliable(reference, to_world);
  if (!agrees(to_object, reference.value, to_world)) to_object = reference.value;
  bound_errors(absolute(to_object - reference.value) + reference.error);
  to_object_stretch = stretch(to_object);
  to_world_stretch = stretch(to_world);
}

void Frame::bound_errors(const Mat4& matrix_error) {
  // Bounds are sums of a few positive terms; each is rounded by less than this.
  constexpr double slack = 1 + 0x1p-48;
  constexpr double smallest =
      0x1p-1074;  // what four products below the normal doubles can be off by: twice it
  const auto raise = [](double& most, double bound) { most = std::max(most, bound * slack); };
  for (int row = 0; row < 3; ++row) {
    const int n = roundings(to_object, row);
    const double constant = gamma(n) * std::abs(to_object[3][row]) + (n > 0 ? 2 * smallest : 0);
    raise(rounding_.slope, gamma(n) * row_sum(to_object, row));
    raise(rounding_.constant, constant);
    raise(error_.slope, gamma(n) * row_sum(to_object, row) + row_sum(matrix_error, row));
    raise(error_.constant, constant + matrix_error[3][row]);
    // Both points are rounded, coordinates of at most largest + 1, and before that so is o + d.
    const double slope = (2 * gamma(n) + unit_roundoff) * row_sum(to_object, row);
    raise(difference_.slope, slope);
    raise(difference_.constant, slope + 2 * constant);
  }
}

}  // namespace trace
