// Inputs of the properties. All shrink towards few and small whole numbers.
#pragma once

#include <rapidcheck.h>

#include <iosfwd>

#include "geometry/frame.hpp"

namespace trace {

void showValue(const Ray& value, std::ostream& out);

}  // namespace trace

namespace trace::test {

// A coordinate in [-8, 8]: a third of them quarters of whole numbers, so that rays run along edges, planes
// and diagonals; a third multiples of 2^-20, whose sums and products are exact; a third multiples of
// 2^-20 * 4/3, with all the digits a double has.
rc::Gen<double> coordinate();

// A point or an edge, with a way to show itself.
struct Place {
  Vec3 at;
};
rc::Gen<Place> place();

// A unit vector along a vector of coordinates; often along an axis or a diagonal.
struct Heading {
  Vec3 along;
};
rc::Gen<Heading> heading();

// A point of the open unit cube [-1, 1]^3, never nearer to its faces than 2^-6.
rc::Gen<Place> place_within();

// A ray from anywhere at a place in the cube of half edge 5/4 around the primitives.
rc::Gen<Ray> aimed_ray();

// translate, rotate, scale as the language applies them; scales between 1/8 and 8 either way, mirrors
// included.
struct Transforms {
  Vec3 move, axis, scale;
  double angle;

  Mat4 matrix() const;
};
rc::Gen<Transforms> transforms();

void showValue(const Place& value, std::ostream& out);
void showValue(const Heading& value, std::ostream& out);
void showValue(const Transforms& value, std::ostream& out);

}  // namespace trace::test
