// A tube around a knot, as a mesh.
#pragma once

#include "geometry/mesh.hpp"

namespace trace {

// Two strands wind about the ring of `radius` around the y axis, a distance `p` from it, opposite one
// another; `q` is how many times they go round it on one way round the axis. With the angle a around the
// axis, from -pi to pi, the middle of a strand (s = 1 and -1) is at
//
//   x = R sin a, y = s p cos(q a), z = R cos a,   R = radius + s p sin(q a),
//
// and each plane through the axis cuts its tube in a circle of radius `tube`. Where 2 q is a whole number the
// ends meet: of an odd one those of different strands, which make one knot. Elsewhere flat disks close them.
// With p = 0 there is one strand, a torus.
struct TorusKnot {
  double radius = 1, tube = 0.15, p = 0.4, q = 3.5;
  static constexpr double most_q = 1000;
};

// 96 (1 + |q|) rings of 48 points a strand, at most 8192, with the normals of the surface itself; texture
// coordinates are the way along a strand and around the tube. All of it is finite where the numbers are, and
// |q| <= most_q.
Mesh make_torus_knot(const TorusKnot& knot);

}  // namespace trace
