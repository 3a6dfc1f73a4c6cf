#include "process/worker_process.hpp"

#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "process/cpu_time.hpp"
#include "process/pidfd.hpp"
#include "process/pipe.hpp"
#include "process/process_files.hpp"

namespace trace {
WorkerProcess::WorkerProcess(int id, ForkedWorker forked)
    : id_(id),
      pid_(forked.pid),
      process_(std::move(forked.process)),
      socket_(std::move(forked.socket)),
      errors_(std::move(forked.errors)) {}

void WorkerProcess::start(JobId id, std::string job, const Limits& limits) {
  job_ = id;
  limits_ = limits;
  started_ = Clock::now();
  stopped_for_ = {};
  clock_stopped_.reset();
  killed_as_.reset();
  figures_ = {};
  errors_text_.clear();
  if (limits.memory_bytes > 0) own_memory_at_start_ = resident_memory(pid_).own;
  Message message;
  message.kind = MessageKind::job;
  message.number = limits.memory_bytes;
  message.body = std::move(job);
  send(std::move(message));
}

void WorkerProcess::send(Message message) {
  writer_.put(std::move(message));
  flush();  // a worker that is gone is noticed by its pidfd
}

std::optional<Message> WorkerProcess::receive() {
  std::optional<Message> message = reader_.read(socket_.get());
  if (message && message->kind == MessageKind::figures && message->body.size() == sizeof figures_) {
    std::memcpy(&figures_, message->body.data(), sizeof figures_);
    return receive();
  }
  if (!message && reader_.closed()) {
    kill();  // if it has not ended already
    socket_.reset();
  }
  return message;
}

void WorkerProcess::read_errors() {
  read_some(errors_, errors_text_);
}

void WorkerProcess::go_on() {
  if (clock_stopped_) stopped_for_ += Clock::now() - *clock_stopped_;
  clock_stopped_.reset();
}

std::optional<Clock::time_point> WorkerProcess::deadline() const {
  if (!busy() || clock_stopped_ || killed_as_ || limits_.timeout.count() <= 0) return std::nullopt;
  return started_ + stopped_for_ + std::chrono::duration_cast<Clock::duration>(limits_.timeout);
}

void WorkerProcess::check_time(Clock::time_point now) {
  const std::optional<Clock::time_point> end = deadline();
  if (!end || now < *end) return;
  killed_as_ = Outcome{Outcome::Kind::timed_out, 0};
  kill();
}

void WorkerProcess::check_memory() {
  if (!memory_limited() || resident_memory(pid_).own <= own_memory_at_start_ + limits_.memory_bytes) return;
  killed_as_ = Outcome{Outcome::Kind::out_of_memory, 0};
  kill();
}

void WorkerProcess::kill() {
  retired_ = true;
  pidfd_send_signal(process_.get(), SIGKILL, nullptr, 0);
}

FinishedJob WorkerProcess::finished(const Outcome& outcome) {
  FinishedJob result;
  result.id = job_.value_or(0);
  result.outcome = outcome;
  result.errors = errors_text_.text();
  job_.reset();
  ++jobs_done_;
  return result;
}

FinishedJob WorkerProcess::finish(Message message) {
  read_errors();  // whatever was written came before the message
  FinishedJob result = finished({});
  result.seconds = figures_.seconds;
  result.cpu_seconds = figures_.cpu_seconds_so_far - cpu_seconds_before_;
  result.peak_memory_bytes = figures_.peak_memory_bytes;
  cpu_seconds_before_ = figures_.cpu_seconds_so_far;
  if (message.kind == MessageKind::answer) {
    result.answer = std::move(message.body);
    return result;
  }
  retired_ = true;
  if (message.kind == MessageKind::out_of_memory) {
    result.outcome = {Outcome::Kind::out_of_memory, 0};
  } else {
    result.outcome = {Outcome::Kind::exited, 1};
    if (!result.errors.empty() && result.errors.back() != '\n') result.errors += '\n';
    result.errors += message.body;
  }
  return result;
}

std::optional<FinishedJob> WorkerProcess::bury() {
  int status = 0;
  rusage usage{};
  while (wait4(pid_, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  read_errors();
  if (!busy()) return std::nullopt;
  Outcome outcome = killed_as_.value_or(outcome_of_status(status));
  if (!killed_as_ && limits_.memory_bytes > 0 && speaks_of_memory(errors_text_.text()))
    outcome = {Outcome::Kind::out_of_memory, 0};
  const std::chrono::duration<double> took = Clock::now() - started_;
  FinishedJob result = finished(outcome);
  result.seconds = took.count();
  result.cpu_seconds = std::max(0.0, cpu_seconds(usage) - cpu_seconds_before_);
  result.peak_memory_bytes = std::uint64_t(usage.ru_maxrss) * 1024;
  return result;
}

}  // namespace trace
