// One worker of a WorkerPool as its supervisor sees it: a process, the connection to it, and its job.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "process/bounded_text.hpp"
#include "process/descriptor.hpp"
#include "process/finished_job.hpp"
#include "process/fork_worker.hpp"
#include "process/limits.hpp"
#include "process/message.hpp"
#include "process/worker.hpp"

namespace trace {

using Clock = std::chrono::steady_clock;

class WorkerProcess {
 public:
  WorkerProcess(int id, ForkedWorker forked);
  WorkerProcess(WorkerProcess&&) = default;
  WorkerProcess& operator=(WorkerProcess&&) = default;

  int id() const { return id_; }
  bool busy() const { return job_.has_value(); }
  std::optional<JobId> job() const { return job_; }
  bool retired() const { return retired_; }  // it has been killed or has said it ends: it gets no more jobs
  int jobs_done() const { return jobs_done_; }

  int socket() const { return socket_.get(); }
  int errors() const { return errors_.get(); }
  int process() const { return process_.get(); }  // a pidfd: readable once the worker has ended
  bool sending() const { return writer_.pending(); }

  void start(JobId id, std::string job, const Limits& limits);
  void send(Message message);
  void flush() { writer_.flush(socket_.get()); }

  // The next message that has come, except figures, which it keeps.
  std::optional<Message> receive();
  // Takes in what the worker wrote to its standard output and error.
  void read_errors();

  // While a worker waits for another one its time limit does not run.
  void stop_clock() { clock_stopped_ = Clock::now(); }
  void go_on();
  std::optional<Clock::time_point> deadline() const;
  bool memory_limited() const { return busy() && limits_.memory_bytes > 0 && !killed_as_; }

  // Kills it if the job is over a limit.
  void check_time(Clock::time_point now);
  void check_memory();
  void kill();

  // The result of the job, from the worker's last words. Afterwards the worker has no job.
  FinishedJob finish(Message result);
  // The result of the job of a worker that has ended without a last word; reaps the worker. Nothing where it
  // had no job.
  std::optional<FinishedJob> bury();

 private:
  FinishedJob finished(const Outcome& outcome);

  int id_;
  pid_t pid_ = -1;
  Descriptor process_, socket_, errors_;
  MessageReader reader_;
  MessageWriter writer_;

  std::optional<JobId> job_;
  Limits limits_;
  Clock::time_point started_;
  Clock::duration stopped_for_{};
  std::optional<Clock::time_point> clock_stopped_;
  std::uint64_t own_memory_at_start_ = 0;
  std::optional<Outcome> killed_as_;
  bool retired_ = false;
  JobFigures figures_;
  double cpu_seconds_before_ = 0;
  BoundedText errors_text_;
  int jobs_done_ = 0;
};

}  // namespace trace
