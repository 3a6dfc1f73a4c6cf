// The place of a ray's line nearest to the origin of its space, without cancellation from far away.
#pragma once

#include "geometry/double_double.hpp"
#include "geometry/ray.hpp"
#include "geometry/rounding.hpp"

namespace trace {

struct NearestPoint {
  Vec3 place;
  double t;  // of the ray there
};

// With the moment m = o x d the place is d x m / d.d. The components of m are off by 3/2 units in the last
// place however far o is, so the place is off by a few units in the last place of its largest coordinate,
// where o + t d would be off by as much of o's. t is rounded once from a sum that is good to 2^-100 of its
// terms.
inline NearestPoint nearest_point(const Ray& ray) {
  const Vec3 &o = ray.origin, &d = ray.direction;
  const double square = glm::dot(d, d);
  const DoubleDouble along = exact_product(o.x, d.x) + exact_product(o.y, d.y) + exact_product(o.z, d.z);
  return {accurate_cross(d, accurate_cross(o, d)) / square, -along.rounded() / square};
}

}  // namespace trace
