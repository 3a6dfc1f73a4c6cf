// A place in the scene graph: the transforms from the root down to it, multiplied, and their inverses.
#pragma once

#include "geometry/local_transform.hpp"

namespace trace {

class Placement {
 public:
  Placement() = default;  // the world itself

  // The place inside this one that `local` makes.
  Placement inside(const LocalTransform& local) const;

  const Mat4& to_world() const { return to_world_; }

  // The product of the inverses, with a bound of its distance from the inverse of the exact placement, which
  // is the product of the exact transforms. The bound grows with the number of rotations, not exponentially.
  const BoundedMatrix& to_object() const { return to_object_; }

  // Whether to_object() can be taken for the inverse. If not, the place may still have one.
  bool reliable() const { return trace::reliable(to_object_, to_world_); }

 private:
  Mat4 to_world_{1};
  BoundedMatrix to_object_;
  // Bounds of the length of the error of each column's first three entries. Rotations keep lengths, while the
  // entries' own bounds would grow by up to sqrt(3) with each of them.
  Vec4 column_error_{0};
};

}  // namespace trace
