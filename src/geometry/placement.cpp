#include "geometry/placement.hpp"

#include <algorithm>

#include "geometry/rounding.hpp"

namespace trace {

// For exact inverses A = a + Ea of the local transform and B = b + Eb of this place the computed product ab
// is off by at most |a| |Eb| + |Ea| (|b| + |Eb|) + rounding. The upper part of a column of Eb, Eb_j, becomes
// A Eb_j + (offset of A) (its fourth entry), so its length is also bounded by that of A's stretch.
Placement Placement::inside(const LocalTransform& local) const {
  Placement result;
  result.to_world_ = to_world_ * local.matrix;

  const Mat4& a = local.inverse.value;
  const Mat4& b = to_object_.value;
  result.to_object_.value = a * b;
  constexpr double slack = 1 + 0x1p-47;  // for the roundings of the bound itself
  const Mat4 carried = slack * (absolute(a) * to_object_.error);
  const Mat4 fresh =
      slack * (local.inverse.error * (absolute(b) + to_object_.error)) + product_rounding(a, b);
  const double offset = glm::length(Vec3(a[3]));
  for (int column = 0; column < 4; ++column) {
    const double length = slack * (local.inverse_stretch * column_error_[column] +
                                   offset * to_object_.error[column][3] + glm::length(Vec3(fresh[column])));
    Vec4& error = result.to_object_.error[column];
    error = slack * (carried[column] + fresh[column]);
    for (int row = 0; row < 3; ++row) error[row] = std::min(error[row], length);
    result.column_error_[column] = std::min(length, slack * glm::length(Vec3(error)));
  }
  return result;
}

}  // namespace trace
