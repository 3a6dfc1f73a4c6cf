// Places for samples that fill a surface evenly, the same in every run.
#pragma once

#include <cstdint>

#include "geometry/vector.hpp"

namespace trace {

// Sample k of n x n in the unit square, one in each of n x n squares. In x and in y they are in the middles
// of n^2 equal parts, one in each.
Vec2 multi_jittered(int n, int k);

// The bits of k behind the binary point in reverse: 0, 1/2, 1/4, 3/4, ... and half of the last bit.
double radical_inverse(std::uint32_t k);

// From the unit square to the unit disc, equal areas to equal areas (Shirley and Chiu, "A Low Distortion Map
// Between Disk and Square", Journal of Graphics Tools 2(3), 1997).
Vec2 on_disc(const Vec2& s);

// From the unit square to the unit sphere, equal areas to equal areas: x to the height, y to the angle about
// z.
Vec3 on_sphere(const Vec2& s);

// Radii of points in the unit ball whose density is proportional to 1 / sqrt(1 - r^2), so that seen from any
// side they make an evenly bright disc: the integral of it along a line that passes the centre at a distance
// below 1 is pi, whatever the distance. `part` of the points are within the radius, 0 to 1.
double radius_of_even_disc(double part);

}  // namespace trace
