// Rays at the very places where arithmetic has to choose a side.
#pragma once

#include "geometry/mesh.hpp"
#include "tests/support/scene_random.hpp"

namespace trace::hard {

using test::Random;

// `x` moved by `steps` representable numbers.
double steps_from(double x, int steps);

// All 52 bits of the fraction are drawn, in [0, 1).
double fraction(Random& random);

// Evenly over the sphere.
Vec3 unit_vector(Random& random);

// A turn about a random axis. As everywhere here, what is drawn first is drawn in a statement, or within
// braces, of its own: the order of arguments and operands is the compiler's, and the rays shall not be.
Mat4 random_turn(Random& random);

// From `origin` towards a corner, or a point of an edge, of a random face; in half of the cases one
// coordinate of the direction is then 1, 2, 4 ... 64 ulps off.
Ray aimed_at_edges(Random& random, const Mesh& mesh, const Vec3& origin);

}  // namespace trace::hard
