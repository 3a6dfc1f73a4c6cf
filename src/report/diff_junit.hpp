// `trace diff --junit`: a test case a pair.
#pragma once

#include <string>

#include "report/diff_report.hpp"

namespace trace {

// Pictures that differ are failures; pictures that are missing, extra or cannot be read are errors. The class
// of a case is its folder, or the suite's name where it has none.
std::string diff_junit(const DiffReport& report);

}  // namespace trace
