// What a WorkerPool tells of a job.
#pragma once

#include <cstdint>
#include <string>

#include "process/outcome.hpp"

namespace trace {

using JobId = std::uint64_t;

struct FinishedJob {
  JobId id = 0;
  Outcome outcome;
  bool answered() const { return outcome.kind == Outcome::Kind::answered; }
  std::string answer;  // where it answered
  std::string errors;  // what it wrote to standard output and error, bounded; then the text of its exception
  double seconds = 0;
  double cpu_seconds = 0;  // with the programs it ran and waited for
  std::uint64_t peak_memory_bytes =
      0;  // the most its worker had resident during the job, shared pages included
};

}  // namespace trace
