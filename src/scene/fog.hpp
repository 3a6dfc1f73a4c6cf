// Fog between the eye and what it sees.
#pragma once

#include <optional>

#include "geometry/ray.hpp"

namespace trace {

// Whoever looks through the fog sees its colour instead of a part of what is there. The part depends on how
// deep in the fog that is: its distance along the ray or, with an axis, its place along it, whichever side
// the eye is on. Only what the eye sees directly is in the fog; lights, mirrors and glass are not.
struct Fog {
  Rgb color{0};
  std::optional<Vec3> axis;   // of unit length; depth is the coordinate along it, from the world's origin
  double start = 0;           // the depth where the fog begins
  std::optional<double> end;  // where nothing is seen through it; linear in between. May be below `start`
  double density = 0;         // without an end: 1 - exp(-density * (depth - start))

  // The fog's part of what a ray shows that hits something at `t`, or nothing where it is negative: 0 to 1.
  // With an axis, a ray that hits nothing ends infinitely far along it.
  double part(const Ray& ray, double t) const;
};

}  // namespace trace
