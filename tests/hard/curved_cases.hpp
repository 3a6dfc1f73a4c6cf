// Rows 6 and 7: spheres, cylinders, cones and tori where the quadratic is hard.
#pragma once

#include "tests/hard/hard_case.hpp"

namespace trace::hard {

HardCase far_sphere_case();
HardCase placed_sphere_case();
HardCase cylinder_case();
HardCase cone_case();
HardCase torus_case();

}  // namespace trace::hard
