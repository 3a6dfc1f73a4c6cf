// `trace diff --csv`: a header and one row a pair.
#pragma once

#include <string>

#include "report/diff_report.hpp"

namespace trace {

// Columns: name, reference, test, then those of comparison_csv.hpp.
std::string diff_csv(const DiffReport& report);

}  // namespace trace
