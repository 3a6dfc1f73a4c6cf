// Rows 8 and 9: normals and spaces of objects.
#pragma once

#include "tests/hard/hard_case.hpp"

namespace trace::hard {

HardCase normals_case();
HardCase undone_case();
HardCase shared_t_case();

}  // namespace trace::hard
