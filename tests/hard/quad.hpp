// Truth in 113 binary digits: numbers, vectors and rays in __float128.
//
// Doubles are exact in it, a product of two is, and sums of products of coordinates up to 1e8 keep 17 digits
// behind what doubles have at all.
#pragma once

#include "geometry/ray.hpp"

namespace trace::hard {

__extension__ typedef __float128 Quad;

inline Quad magnitude(Quad x) {
  return x < 0 ? -x : x;
}

// Newton's step from the root in double doubles its 53 digits; a second one clears what is left. For x that
// a double can hold; NaN for NaN and for what is negative.
inline Quad root(Quad x) {
  const double guess = std::sqrt(static_cast<double>(x));
  if (guess == 0) return 0;
  Quad r = guess;
  for (int step = 0; step < 2; ++step) r = (r + x / r) / 2;
  return r;
}

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
