// A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z + J = 0, within limits and without caps, seen
// from both sides.
//
// With M the symmetric matrix of the squares and g = (G, H, I), the places o + t d of a ray are on it where
// a t^2 + 2 h t + c = 0 with a = d.Md, h = d.(Mo + g / 2), c = o.Mo + g.o + J. Where h^2 - ac is more than
// 2^-16 of the sizes of its terms it is taken in doubles, and a Newton step from the place found clears what
// was lost: the place is then as near as q can be told there. Else everything is taken in twice the digits
// (double_double.hpp), so that from 1e8 sizes away a hit and a miss are still told apart.
#pragma once

#include <array>
#include <memory>

#include "geometry/bounds.hpp"

namespace trace {

class Quadric {
 public:
  using Coefficients = std::array<double, 10>;  // A to J

  // Finite, not all 0. It exists within `limits`, which may be infinite; there it lies within `extent`.
  Quadric(const Coefficients& coefficients, const Bounds& limits, const Bounds& extent);
  // The whole of it.
  explicit Quadric(const Coefficients& coefficients)
      : Quadric(coefficients, Bounds::everything(), Bounds::everything()) {}

  Bounds bounds() const { return form_->extent; }

  // The nearest place within the limits. The normal faces the ray and has unit length.
  bool intersect(const Ray& ray, LocalHit& hit) const;

  // From the surface, at least as much as the real one next to it.
  double distance(const Vec3& p, const Vec3& normal) const;

  // Where the extent is bounded, across it in x and z; else by_direction().
  Vec2 texture_coordinates(const Vec3& p, const Vec3& normal) const;

 private:
  // Shared, so that a shape is no larger for it.
  struct Form {
    Coefficients coefficients;
    Bounds limits, extent;
  };

  std::shared_ptr<const Form> form_;
};

}  // namespace trace
