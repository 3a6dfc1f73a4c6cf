// Row 4: rays through a point of a box, where 0 * inf and signed zeros meet the slabs.
#pragma once

#include "tests/hard/hard_case.hpp"

namespace trace::hard {

HardCase slab_case();

}  // namespace trace::hard
