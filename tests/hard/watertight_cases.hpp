// Rows 1 and 2: rays aimed at edges and corners of triangles.
#pragma once

#include "tests/hard/hard_case.hpp"

namespace trace::hard {

HardCase watertight_case();
HardCase edge_function_case();

}  // namespace trace::hard
