// Rows 3 and 11: the hierarchies against one object, one face after the other.
#pragma once

#include "tests/hard/hard_case.hpp"

namespace trace::hard {

HardCase mesh_hierarchy_case();
HardCase scene_hierarchy_case();
HardCase coincident_case();

}  // namespace trace::hard
