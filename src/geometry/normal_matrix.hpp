// How normals go from the space of an object to the world.
#pragma once

#include "geometry/vector.hpp"

namespace trace {

// The transpose of the inverse of the upper 3 x 3 of `placement`, up to a positive factor, so that normals
// stay outward under mirrors. GLM's own wherever that is right, for its bits are in the pictures; otherwise
// the cofactors with the sign of the determinant, times a power of two (Turkowski, "Properties of
// Surface- Normal Transformations", Graphics Gems 1990), which are right for the smallest scales and for flat
// objects.
Mat3 normal_matrix(const Mat4& placement);

}  // namespace trace
