// How much of what a ray sees can come through to the picture: the threshold that ends a path early.
//
// A path's weight is 1 for the primary ray. A mirrored ray has its surface's weight times the largest channel
// of |kr|; a refracted ray has its surface's. The weight of the surface that a ray hits is the ray's, times
// the largest channel of kt^t where the ray came a way t through glass of transmission kt. That way is known
// only when the ray has been traced, so it ends no ray but those behind the hit. A ray of a weight below
// ShadingOptions::least_contribution is not traced and shows black. By DialectRules::transmission_at_surfaces
// a refracted ray has its surface's weight times the largest channel of |kt|, and the way counts nothing.
#pragma once

#include "geometry/rounding.hpp"
#include "shading/transmittance.hpp"

namespace trace {

struct Path {
  double weight = 1;           // of the ray
  const Rgb* glass = nullptr;  // kt of what the ray goes through; none for air

  // At a hit at distance `t`. A transmittance that is not finite says nothing and changes nothing.
  double weight_at(double t) const {
    if (!glass) return weight;
    const PartialRgb left = transmittance(*glass, t);
    return left.finite() ? weight * largest(left.value) : weight;
  }
};

}  // namespace trace
