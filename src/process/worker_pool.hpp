// Jobs done by forked processes, so that one that crashes, hangs or exhausts memory takes nothing with it.
//
// The supervisor is the process that owns the pool. Workers are forked from it when there is a job for them,
// so they share what it holds in memory at that time. They stay for further jobs, one at a time; one that
// crashed, threw or was killed at a limit is replaced. Its job is reported and never tried again.
//
// What the supervisor must keep to:
// - It has a single thread whenever it calls wait(), which forks: only the thread that forks goes on in the
//   new process. So it must not have used TBB or OpenImageIO, which keep threads; the workers may.
// - Limits are enforced, and idle workers given their next job, inside wait() only.
// - The thread that made the pool stays: workers are killed when it ends, even by SIGKILL.
//
// Workers are in the supervisor's process group and ignore SIGINT, SIGTERM and SIGHUP, which are for the
// supervisor to decide on; Ctrl-Z reaches them.Standard input is empty; what they write to standard output
// and error comes back with the job. Programs are to be started by run_program(), whose programs end with the
// worker; processes a job starts in other ways are not looked after.
//
// The timeout is of the wall clock, less the time waited for a blob that another worker makes. The memory
// limit is what the job may add to what its worker has at the start: allocations beyond it fail with
// std::bad_alloc (RLIMIT_DATA), and a worker that has more resident is killed within milliseconds.
//
// Staying workers against one fork a job, measured over two workers on two cores, microseconds a job, minima:
// 44 against 498 for an empty answer, 378 against 1779 for one of a megabyte; where the supervisor holds 200
// MB, 188 against 13436, since a fork copies the page tables.
#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "process/blob_broker.hpp"
#include "process/finished_job.hpp"
#include "process/limits.hpp"
#include "process/worker.hpp"
#include "process/worker_process.hpp"

namespace trace {

struct WorkerPoolOptions {
  int workers = 1;          // at a time
  int jobs_per_worker = 0;  // after so many a worker is replaced; 0: never
};

class WorkerPool {
 public:
  WorkerPool(WorkerPoolOptions options, Work work);
  WorkerPool(int workers, Work work) : WorkerPool(WorkerPoolOptions{workers, 0}, std::move(work)) {}
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;
  ~WorkerPool() { stop(); }

  // Queued, in order. The id is the caller's, to tell jobs apart.
  void submit(JobId id, std::string job, Limits limits = {});

  // The jobs that finished since the last call. Returns as soon as there is one, when the time is over, when
  // a signal came, or when nothing is left to do. Throws std::system_error where no worker at all can be
  // started.
  std::vector<FinishedJob> wait(std::chrono::milliseconds at_most);

  std::vector<JobId> running() const;
  std::size_t queued() const { return queue_.size(); }
  bool idle() const;  // nothing queued or running

  // Kills the workers and forgets what was running and queued. The pool can be used again.
  void stop();

 private:
  struct Queued {
    JobId id;
    std::string job;
    Limits limits;
  };

  void start_jobs();
  WorkerProcess* free_worker();
  Clock::time_point next_check(Clock::time_point end) const;
  bool poll_until(Clock::time_point end);
  void serve(WorkerProcess& worker);
  void obey(WorkerProcess& worker, Message message);
  void tell(std::vector<BlobBroker::Reply> replies);
  void check_limits();
  void bury(std::size_t index);

  WorkerPoolOptions options_;
  Work work_;
  std::deque<Queued> queue_;
  std::vector<WorkerProcess> workers_;
  BlobBroker blobs_;
  std::vector<FinishedJob> finished_;
  int next_worker_ = 0;
};

}  // namespace trace
