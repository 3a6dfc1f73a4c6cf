// A batch's results for spreadsheets and for servers of continuous integration.
#pragma once

#include <string>

#include "batch/record.hpp"

namespace trace {

// One row a result: scene, renderer, outcome, verdict, reason, diagnosis, figures, times. What is not known
// is empty. Of a summary (summary.hpp), as the next.
std::string batch_csv(const Record& summary);

// One test case a result; the renderer is its class where there are several.
std::string batch_junit(const Record& summary);

}  // namespace trace
