// Linear maps in 113 digits, and what to do to normals; placements are in tests/support/quad_matrix.hpp.
#pragma once

#include "geometry/vector.hpp"
#include "tests/hard/quad.hpp"

namespace trace::hard {

// By its columns.
struct QuadLinear {
  QuadVec c0, c1, c2;

  explicit QuadLinear(const Mat4& m) : c0(Vec3(m[0])), c1(Vec3(m[1])), c2(Vec3(m[2])) {}
  QuadLinear(const QuadVec& a, const QuadVec& b, const QuadVec& c) : c0(a), c1(b), c2(c) {}

  Quad determinant() const { return dot(c0, cross(c1, c2)); }
  // determinant * transposed inverse, defined for every matrix.
  QuadLinear cofactors() const { return {cross(c1, c2), cross(c2, c0), cross(c0, c1)}; }
  QuadVec operator*(const QuadVec& v) const { return v.x * c0 + v.y * c1 + v.z * c2; }
  // The inverse times v; the determinant must not be zero.
  QuadVec solve(const QuadVec& v) const {
    const QuadLinear f = cofactors();
    return (1 / determinant()) * QuadVec(dot(f.c0, v), dot(f.c1, v), dot(f.c2, v));
  }
};

}  // namespace trace::hard
