// Where a ray meets a torus: in 113 digits, and by the textbook's quartic in doubles.
#pragma once

#include <optional>

#include "tests/hard/quad.hpp"
#include "tests/hard/torus_rays.hpp"

namespace trace::hard {

// How far a place is from the surface: above it, outside the tube.
Quad height_above(const RingShape& shape, const QuadVec& p);

// The first t > 0 at which the ray crosses the surface.
std::optional<Quad> true_torus(const RingShape& shape, const QuadRay& ray);

// The quartic in t from the ray's origin, solved by Ferrari's formula in complex numbers; what is less than
// 1e-8 off the real line and beyond 1e-8 counts.
std::optional<double> textbook_torus(const RingShape& shape, const Ray& ray);

}  // namespace trace::hard
