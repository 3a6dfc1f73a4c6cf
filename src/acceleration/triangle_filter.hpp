// Which of a leaf's triangles a ray certainly misses, told in 32 bits for several at once.
//
// Like boxes it only rejects: of what it rejects meets() (geometry/triangle.hpp) says `none` or a t beyond
// the limit. It is the same form, relative to the centre c of the hierarchy, and the same bound with the
// roundoff e = 2^-24 of floats. With |d| <= 1 in each coordinate, edges of at most s, the way f from corner a
// to the origin o, and reach r, a bound on the sums of sizes |f| and |o - c| + |a - c|:
//   inputs    d, ab, ac: e relative; f: 2 e r in the sum of its coordinates
//   p = d x ac   at most 2 s,      off by 4 e 2 s
//   det = ab p   at most 6 s^2,    off by (6 + 24 + 18) e s^2
//   u = f p      at most 2 s r,    off by (4 + 8 + 6) e s r
//   q = f x ab   in sum 2 s r,     off by (4 + 2 + 4) e s r
//   v = d q      at most 2 s r,    off by (10 + 2 + 6) e s r
//   t = ac q     at most 2 s^2 r,  off by 18 e s^2 r
// u + v - det is off by less than 40 e s r + 52 e s^2, its own roundings included; 64 e s (r + s) covers all,
// second orders and what meets() allows for doubles, 2^-29 of it, too. Where the determinant is no larger
// than that its sign is not known and nothing is rejected; nor where s or r is so small or large that
// products could leave the range of floats: the bound is infinite there.
#pragma once

#include <cstdint>

#include "acceleration/bvh.hpp"
#include "acceleration/large_vector.hpp"
#include "geometry/triangle.hpp"

namespace trace {

// The triangles of a leaf of n, the first of which is item i, are ten runs of n floats from 10 i on: x, y, z
// of a - c, of ab and of ac, and s.
struct TriangleFilter {
  static constexpr std::size_t floats = 10;
  static constexpr std::size_t beyond = 8;  // floats that may be read after the last

  LargeVector<float> values;

  static std::size_t size_for(std::size_t triangles) { return floats * triangles + beyond; }

  void set(std::size_t first, std::size_t count, std::size_t place, const Triangle& triangle,
           const Vec3& centre) {
    const auto put = [&](std::size_t run, const Vec3& v) {
      float* at = values.data() + floats * first + run * count + place;
      for (int axis = 0; axis < 3; ++axis, at += count) *at = static_cast<float>(v[axis]);
    };
    put(0, triangle.a - centre);
    put(3, triangle.ab);
    put(6, triangle.ac);
    values[floats * first + 9 * count + place] = size_of(triangle);
  }

  // 64 e is in the ray's.
  static float size_of(const Triangle& triangle) {
    const bool in_range = triangle.size >= 0x1p-30 && triangle.size <= 0x1p30;
    return in_range ? static_cast<float>(triangle.size * (1 + 0x1p-22))
                    : std::numeric_limits<float>::infinity();
  }
};

// The ray as the filter sees it.
struct FilterRay {
  float origin[3], direction[3];
  float reach;

  FilterRay(const Vec3& centre, const Ray& ray, double ray_reach) : reach(rounded_up(ray_reach)) {
    for (int axis = 0; axis < 3; ++axis) {
      origin[axis] = static_cast<float>(ray.origin[axis] - centre[axis]);
      direction[axis] = static_cast<float>(ray.direction[axis]);
    }
  }

  static float rounded_up(double ray_reach) {
    return ray_reach <= 0x1p50 ? static_cast<float>(ray_reach * (1 + 0x1p-22))
                               : std::numeric_limits<float>::infinity();
  }

  // What meets() allows beyond `limit`, and as much again for the roundings of the product with det.
  float furthest(double limit) const { return static_cast<float>(limit * (1 + 0x1p-19)) + 0x1p-19f * reach; }
};

}  // namespace trace
