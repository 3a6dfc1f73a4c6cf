// Where a ray meets a quadric, and when rounding could decide it.
#pragma once

#include "geometry/ray.hpp"
#include "geometry/rounding.hpp"

namespace trace {

// Of the distance from the z axis, round which cones and cylinders stand.
inline double radius_squared(const Vec3& p) {
  return p.x * p.x + p.y * p.y;
}

// Roots of a t^2 + 2 h t + c = 0.
struct Roots {
  double first, second;  // (-h - root) / a and (-h + root) / a; in this order by size where a > 0
};

// A discriminant or a fraction of one, and the sum of the sizes of its terms.
struct Discriminant {
  double value, terms;

  // As the textbook has it, from coefficients that are rounded themselves, it is off by less than gamma(8)
  // terms. Beyond 2^-16 terms it is good to 2^-34, and a hit is within half of that, 2^-35 of the size of the
  // object, of its surface. Else a form without cancellation must be asked.
  bool is_well_conditioned() const { return std::abs(value) > 0x1p-16 * terms; }

  // For the form without cancellation, whose few terms are each off by less than gamma(8). Where it cannot
  // tell either, a ray touches the quadric as far as doubles can say, and the course's pictures have the last
  // word.
  bool is_decided() const { return std::abs(value) > gamma(8) * terms; }
};

// From a square root and coefficients that are accurate, without cancellation: the root that is a sum is
// formed as such, the other by c / a = their product. Press et al., "Numerical Recipes", section 5.6. a may
// be tiny or zero: one root is then far away or infinite.
inline Roots stable_roots(double a, double h, double c, double root) {
  const double q = h > 0 ? -(h + root) : root - h;
  return h > 0 ? Roots{q / a, c / q} : Roots{c / q, q / a};
}

// Whether a ray that starts on a sphere or cylinder goes into it and so meets its far side. `inward` is the
// cosine with the inward normal, off by `unsure` at most. Of a ray that is tangent as far as that tells, the
// rounding of the origin decides, as in the course's pictures: a little inside, and it does.
inline bool leaves_inward(double inward, double unsure, double far_t) {
  return std::abs(inward) <= unsure ? far_t > course_least_t : inward > 0;
}

}  // namespace trace
