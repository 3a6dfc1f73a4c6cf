// The transforms of the scene language as matrices, each with its inverse.
//
// The inverse is not computed from the matrix: a translation is undone by the opposite one, a scale by the
// reciprocal factors, a rotation by its transpose; only a matrix given by its numbers is inverted.
#pragma once

#include "geometry/bounded_matrix.hpp"

namespace trace {

struct LocalTransform {
  Mat4 matrix{1};
  BoundedMatrix inverse;       // of the exact transform
  double inverse_stretch = 1;  // at least the largest factor by which the inverse lengthens a vector
};

LocalTransform translation(const Vec3& offset);

// Right-handed by `angle` radians about an axis of any length. An axis of zeros gives a matrix of NaN.
LocalTransform rotation(const Vec3& axis, double angle);

// A factor of 0 gives an inverse that is not finite.
LocalTransform scaling(const Vec3& factors);

LocalTransform given_matrix(const Mat4& matrix);

}  // namespace trace
