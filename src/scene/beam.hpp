// What keeps a light from shining equally to all sides: a cone, a power of the cosine (Warn, "Lighting
// Controls for Synthetic Images", SIGGRAPH 1983), flaps, a hole in front of it, and an end.
//
// Each limit that is given counts, and what they leave of the light is multiplied.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "geometry/vector.hpp"

namespace trace {

// A box of the world outside of which the light does not shine, its faces included. An edge that is not given
// is infinite.
struct Flaps {
  enum class Outline {
    box,
    half,    // of the box: seen along y, the triangle at the corner of the least x and z
    circle,  // seen along y, the circle through the corners of the box; the box's y counts
  };
  Vec3 low{-std::numeric_limits<double>::infinity()};
  Vec3 high{std::numeric_limits<double>::infinity()};
  Outline outline = Outline::box;

  // Points of surfaces on a face of the box are within it though they are off by roundings: by `slack` in
  // each coordinate.
  bool let_through(const Vec3& point, double slack) const;
};

// A hole through which the light shines: a regular polygon around the light's axis, two triangles that make a
// star, or a circle. Its edge belongs to it.
class Aperture {
 public:
  // `corners`: 3 or more, the first where `up` points; 0 is a circle. `radius` is that of the corners.
  // `x` and `up` are of unit length and at right angles.
  Aperture(int corners, bool star, double radius, const Vec3& x, const Vec3& up);

  // A square of 2 `half` by 2 `half`, upright.
  static Aperture square(double half, const Vec3& x, const Vec3& up);

  // `across`: from the light's axis, in the plane of the hole.
  bool lets_through(const Vec3& across, double slack) const;

 private:
  bool holds(const Vec2& p, double slack) const;

  Vec3 x_, up_;
  double radius_ = 0, apothem_ = 0;
  bool star_ = false;
  std::vector<Vec2> outward_;  // across each edge; none of a circle
};

struct Beam {
  Vec3 direction{0};  // of unit length; zero: none, and then only flaps and `reach` limit the light

  // Cosines of the angle to the direction: below the first no light, from the second on all of it, and
  // between them the smooth step 3 t^2 - 2 t^3 of the cosine.
  double cosine_of_edge = -1, cosine_of_full = -1;
  double exponent = 0;  // of the cosine; with one, there is no light behind

  // The light fades by (1 - distance / reach)^2.
  double reach = std::numeric_limits<double>::infinity();

  std::optional<Flaps> flaps;
  std::optional<Aperture> aperture;
  // How far in front of the light the hole is; 0: the beam does not spread, and goes both ways.
  double aperture_distance = 0;

  bool limits_anything() const;

  // What is left of a light in `position` at a point `distance` away, 0 to 1. `towards` is the unit vector
  // from the point to the light.
  double share(const Vec3& position, const Vec3& point, const Vec3& towards, double distance) const;
};

// The smooth step between two numbers; where they are the same, the step there.
double smooth_step(double from, double to, double x);

}  // namespace trace
