// Row 10 and the pictures as a whole: scenes told in other words.
#pragma once

#include "tests/hard/hard_case.hpp"

namespace trace::hard {

HardCase moved_box_case();
HardCase retold_case();

}  // namespace trace::hard
