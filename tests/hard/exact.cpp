#include "tests/hard/exact.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/quad.hpp"

namespace trace::hard {

using test::magnitude;
using test::Quad;

namespace {

// Coordinates as integers: each the number times the same power of two.
using Integers = std::array<mpz_class, 3>;

int lowest_exponent(const Vec3& v, int lowest) {
  for (int axis = 0; axis < 3; ++axis) {
    int exponent = 0;
    if (v[axis] != 0) {
      std::frexp(v[axis], &exponent);
      lowest = std::min(lowest, exponent - 53);
    }
  }
  return lowest;
}

Integers integers(const Vec3& v, int lowest) {
  Integers result;
  for (int axis = 0; axis < 3; ++axis) {
    int exponent = 0;
    const double mantissa = std::frexp(v[axis], &exponent);
    if (mantissa == 0) continue;
    result[axis] = static_cast<long>(std::ldexp(mantissa, 53));
    result[axis] <<= static_cast<mp_bitcnt_t>(exponent - 53 - lowest);
  }
  return result;
}

int sign_in_integers(const Ray& ray, const Vec3& p, const Vec3& q) {
  constexpr int highest = 2000;
  const int lowest = lowest_exponent(ray.origin, lowest_exponent(p, lowest_exponent(q, highest)));
  if (lowest == highest) return 0;
  const Integers o = integers(ray.origin, lowest);
  const Integers d = integers(ray.direction, lowest_exponent(ray.direction, highest));
  Integers a = integers(p, lowest), b = integers(q, lowest);
  for (int axis = 0; axis < 3; ++axis) {
    a[axis] -= o[axis];
    b[axis] -= o[axis];
  }
  mpz_class sum = d[0] * (a[1] * b[2] - a[2] * b[1]);
  sum += d[1] * (a[2] * b[0] - a[0] * b[2]);
  sum += d[2] * (a[0] * b[1] - a[1] * b[0]);
  return sgn(sum);
}

struct QuadVec {
  Quad x, y, z;
};

QuadVec difference(const Vec3& p, const Vec3& q) {
  return {Quad(p.x) - q.x, Quad(p.y) - q.y, Quad(p.z) - q.z};
}
QuadVec cross(const QuadVec& a, const QuadVec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Quad dot(const QuadVec& a, const QuadVec& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace

int edge_sign(const Ray& ray, const Vec3& p, const Vec3& q) {
  const QuadVec a = difference(p, ray.origin), b = difference(q, ray.origin);
  const QuadVec d{ray.direction.x, ray.direction.y, ray.direction.z};
  const Quad value = dot(d, cross(a, b));
  // Each of the six products has two differences, two multiplications and at most three additions, each
  // within a relative 2^-113: below 8 * 2^-113 of the sum of their magnitudes, itself rounded by as little.
  const Quad size = magnitude(d.x) * (magnitude(a.y * b.z) + magnitude(a.z * b.y)) +
                    magnitude(d.y) * (magnitude(a.z * b.x) + magnitude(a.x * b.z)) +
                    magnitude(d.z) * (magnitude(a.x * b.y) + magnitude(a.y * b.x));
  const Quad bound = size * 0x1p-109;
  if (value > bound) return 1;
  if (value < -bound) return -1;
  return sign_in_integers(ray, p, q);
}

EdgeSigns edge_signs(const Ray& ray, const Corners& triangle) {
  return {edge_sign(ray, triangle.b, triangle.c), edge_sign(ray, triangle.c, triangle.a),
          edge_sign(ray, triangle.a, triangle.b)};
}

bool line_hits(const Ray& ray, const Corners& triangle) {
  return edge_signs(ray, triangle).inside();
}

double plane_t(const Ray& ray, const Corners& triangle) {
  const QuadVec normal = cross(difference(triangle.b, triangle.a), difference(triangle.c, triangle.a));
  const QuadVec d{ray.direction.x, ray.direction.y, ray.direction.z};
  return static_cast<double>(dot(normal, difference(triangle.a, ray.origin)) / dot(normal, d));
}

}  // namespace trace::hard
