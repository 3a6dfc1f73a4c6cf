// `trace diff --json`: docs/schemas/diff-1.schema.json.
#pragma once

#include <string>

#include "report/diff_report.hpp"

namespace trace {

// Ends with a newline.
std::string diff_json(const DiffReport& report);

}  // namespace trace
