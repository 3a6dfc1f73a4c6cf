#include "geometry/normal_matrix.hpp"

#include "geometry/rounding.hpp"

namespace trace {
namespace {

using Extended = long double;
using ExtendedVec3 = glm::vec<3, Extended, glm::defaultp>;
using ExtendedMat3 = glm::mat<3, 3, Extended, glm::defaultp>;

// Neither overflow nor underflow when a normal is carried over and normalised, and as good as the inverse
// computed with 11 bits more, compared with the largest entry of each column: a normal is a sum of columns.
bool agrees(const Mat3& inverse_transpose, const ExtendedMat3& cofactors, Extended determinant) {
  for (int column = 0; column < 3; ++column) {
    const ExtendedVec3 truth = cofactors[column] / determinant;
    const ExtendedVec3 off = glm::abs(ExtendedVec3(inverse_transpose[column]) - truth);
    const Extended size = largest(inverse_transpose[column]);
    if (!(size > 0x1p-400L && size < 0x1p+400L)) return false;
    for (int row = 0; row < 3; ++row) {
      if (!(off[row] <= 0x1p-40L * size)) return false;
    }
  }
  return true;
}

}  // namespace

Mat3 normal_matrix(const Mat4& placement) {
  const Mat3 usual = glm::transpose(glm::inverse(Mat3(placement)));
  // Three doubles multiply without leaving the range of a long double.
  const ExtendedMat3 m{Mat3(placement)};
  ExtendedMat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  const Extended determinant = glm::dot(m[0], cofactors[0]);
  if (agrees(usual, cofactors, determinant)) return usual;

  Extended size = 0;
  for (int column = 0; column < 3; ++column) {
    const ExtendedVec3 entries = glm::abs(cofactors[column]);
    size = glm::max(size, glm::max(entries.x, glm::max(entries.y, entries.z)));
  }
  if (!(size > 0)) return usual;  // less than a plane
  int exponent = 0;
  std::frexp(size, &exponent);
  // Near the top of the range, so that columns may differ by 600 decades before the smallest is lost.
  const Extended factor = std::ldexp(determinant < 0 ? Extended(-1) : Extended(1), 1000 - exponent);
  return Mat3(cofactors * factor);
}

}  // namespace trace
