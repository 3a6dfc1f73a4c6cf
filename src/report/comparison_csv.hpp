// The columns of one judgement, for tables of many.
#pragma once

#include <string>
#include <vector>

#include "comparison/judge.hpp"

namespace trace {

// "verdict", "reason", "diagnosis", "width", ... All figures of Measurements, the channels up to the fourth.
std::vector<std::string> comparison_columns();

// As many fields as there are columns. A figure that is not known is empty; an infinite PSNR is "inf".
std::vector<std::string> comparison_fields(const Judgement& judgement);

}  // namespace trace
