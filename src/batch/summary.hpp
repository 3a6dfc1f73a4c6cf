// All results of a batch in one: what results.json holds and the HTML report is made from (docs/batch.md).
#pragma once

#include <string>
#include <vector>

#include "batch/batch.hpp"

namespace trace {

struct BatchInfo {
  std::string title, command, started;  // `started` in UTC, ISO 8601
  double seconds = 0;
  std::vector<std::string> renderers;
};

Record summary(const BatchInfo& info, const BatchRun& run);

// 0 all rendered and within tolerance, 1 some beyond, 3 some not rendered; of a summary.
int batch_exit_status(const Record& summary);

}  // namespace trace
