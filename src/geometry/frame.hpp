// The space of an object: its place in the world, and rays carried into it.
#pragma once

#include "geometry/placement.hpp"
#include "geometry/ray.hpp"
#include "geometry/rounding.hpp"
#include "geometry/unit_vector.hpp"

namespace trace {

// A bound that grows with the largest coordinate of a point.
struct LinearBound {
  double slope = 0, constant = 0;
  double at(double largest) const { return slope * largest + constant; }
};

// Built once for each place in the scene graph and shared by the objects there.
struct Frame {
  Mat4 to_world;
  Mat4 to_object;
  Mat3 normal_to_world;  // inverse transpose of the upper 3x3, up to a positive factor

  // The largest row sums of the upper 3x3 without signs: a displacement of at most e in each coordinate of
  // the world is one of at most to_object_stretch e in each coordinate of the object, and the other way
  // round.
  double to_object_stretch = 1;
  double to_world_stretch = 1;

  // to_object is glm::inverse(to_world), whose bits are in the pictures, wherever that is within 2^-40 of the
  // inverse that is composed from those of the transforms; elsewhere (extreme scales, lost digits) the
  // latter.
  explicit Frame(const Placement& placement);
  // The place of a matrix that is exact.
  explicit Frame(const Mat4& matrix) : Frame(Placement().inside(given_matrix(matrix))) {}

  // Whether the inverse exists. Objects in a frame without one are not drawn (zero scale, rotation about a
  // zero axis, singular transform).
  bool invertible() const { return invertible_; }

  // How far to_object * (p, 1), as GLM computes it, can be from p in the space of the exact placement (the
  // product of the exact transforms), in each coordinate, for p with coordinates of at most `largest`.
  double error(double largest) const { return error_.at(largest); }
  const LinearBound& error_bound() const { return error_; }
  // The part of it that differs from point to point: of rounding, against to_object itself.
  double rounding(double largest) const { return rounding_.at(largest); }
  // How far to_object * (o + d, 1) - to_object * (o, 1) can be from to_object * (d, 0), in each coordinate,
  // for a d of unit length and o with coordinates of at most `largest`.
  double difference_error(double largest) const { return difference_.at(largest); }
  const LinearBound& difference_bound() const { return difference_; }

  Vec3 world_normal(const Vec3& n) const { return unit_vector(normal_to_world * n).direction; }

 private:
  void bound_errors(const Mat4& matrix_error);

  LinearBound error_, rounding_, difference_;
  bool invertible_ = true;
};

// A world ray in the space of an object. The direction is of unit length there, so a t found along it is
// `scale` times the t in the world.
struct ObjectRay {
  Ray ray;
  double scale = 1;

  // The direction is the difference of two points, which is the language's way and shows in the pictures'
  // last bits, as long as it is good to 2^-40; far from the origin it is the direction times the matrix.
  ObjectRay(const Frame& frame, const Ray& world) {
    const Vec3 origin(frame.to_object * Vec4(world.origin, 1));
    const Vec3 end(frame.to_object * Vec4(world.origin + world.direction, 1));
    UnitVector along = unit_vector(end - origin);
    if (!(frame.difference_error(largest(world.origin)) <= 0x1p-40 * along.length)) {
      along = unit_vector(Vec3(frame.to_object * Vec4(world.direction, 0)));
    }
    scale = along.length;
    const double origin_error =
        frame.to_object_stretch * world.origin_error + frame.error(largest(world.origin));
    ray = {origin, along.direction, origin_error, world.least_t * scale};
  }
};

}  // namespace trace
