// Row 5: rays that leave a surface.
#pragma once

#include "tests/hard/hard_case.hpp"

namespace trace::hard {

HardCase self_hit_case();
HardCase contact_case();

}  // namespace trace::hard
