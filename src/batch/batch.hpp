// Many jobs done by several processes, with their results kept as they come.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "batch/job.hpp"
#include "batch/journal.hpp"
#include "batch/signal_watch.hpp"

namespace trace {

struct BatchStatus {
  std::size_t done = 0, total = 0;  // jobs of this run, without those that were done before
  std::size_t failures = 0;         // not rendered, or not within tolerance
  std::uint64_t rays = 0;
  double seconds = 0;       // since the start
  double seconds_left = 0;  // estimated; negative where nothing can be said
  std::vector<std::string> running;
};

// Is told what happens; by the process that called run_batch.
class BatchObserver {
 public:
  virtual ~BatchObserver() = default;
  virtual void finished(const Record& record, const BatchStatus& status) = 0;
  virtual void tick(const BatchStatus& status) = 0;  // some ten times a second
};

struct BatchRun {
  std::vector<Record> records;  // of the jobs in their order; of those that were not begun or finished: none
  std::size_t resumed = 0;      // taken from an earlier run without any work
  int signal = 0;               // that interrupted it
};

// Does the jobs with `workers` processes at a time, those first that are likely to take long. What the
// journal says of an earlier run and still holds is not done again. A record is appended to the journal as
// soon as its picture is there, and again with the comparison; then the observer hears of it. To be called
// from a process without other threads. Throws JournalError.
BatchRun run_batch(const std::vector<Job>& jobs, int workers, Journal& journal, const SignalWatch& signals,
                   BatchObserver& observer);

// Whether it was not rendered or is not within tolerance.
bool is_failure(const Record& record);

}  // namespace trace
