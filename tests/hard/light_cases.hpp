// Rows 12, 13 and 14: refraction near the critical angle, the shadow terminator, light where it is undefined.
#pragma once

#include "tests/hard/hard_case.hpp"

namespace trace::hard {

HardCase critical_angle_case();
HardCase terminator_case();
HardCase undefined_light_case();

}  // namespace trace::hard
