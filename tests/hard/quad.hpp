// Truth in 113 binary digits: vectors and rays in __float128.
//
// Sums of products of coordinates up to 1e8 keep 17 digits behind what doubles have at all.
#pragma once

#include "geometry/ray.hpp"
#include "tests/support/quad.hpp"

namespace trace::hard {

using test::magnitude;
using test::Quad;
using test::root;

struct QuadVec {
  Quad x, y, z;

  QuadVec(Quad x_, Quad y_, Quad z_) : x(x_), y(y_), z(z_) {}
  explicit QuadVec(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}
};

inline QuadVec operator+(const QuadVec& a, const QuadVec& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline QuadVec operator-(const QuadVec& a, const QuadVec& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline QuadVec operator*(Quad s, const QuadVec& v) {
  return {s * v.x, s * v.y, s * v.z};
}
inline Quad dot(const QuadVec& a, const QuadVec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline QuadVec cross(const QuadVec& a, const QuadVec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Quad length(const QuadVec& v) {
  return root(dot(v, v));
}

struct QuadRay {
  QuadVec origin, direction;

  explicit QuadRay(const Ray& ray) : origin(ray.origin), direction(ray.direction) {}
  QuadRay(const QuadVec& o, const QuadVec& d) : origin(o), direction(d) {}
  QuadVec at(Quad t) const { return origin + t * direction; }
};

}  // namespace trace::hard
