#include "process/worker_pool.hpp"

#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace trace {
namespace {

// Between two looks at how much memory jobs with a limit have: some ten megabytes can be written in that
// time.
constexpr std::chrono::milliseconds memory_interval{5};

}  // namespace

WorkerPool::WorkerPool(WorkerPoolOptions options, Work work) : options_(options), work_(std::move(work)) {
  options_.workers = std::max(options_.workers, 1);
}

void WorkerPool::submit(JobId id, std::string job, Limits limits) {
  queue_.push_back({id, std::move(job), limits});
}

std::vector<JobId> WorkerPool::running() const {
  std::vector<JobId> ids;
  for (const WorkerProcess& worker : workers_) {
    if (worker.busy()) ids.push_back(*worker.job());
  }
  return ids;
}

bool WorkerPool::idle() const {
  return queue_.empty() &&
         std::none_of(workers_.begin(), workers_.end(), [](const WorkerProcess& w) { return w.busy(); });
}

// A worker without a job, forked if there is room for one. Null where all are at work.
WorkerProcess* WorkerPool::free_worker() {
  int there = 0;  // those that are about to end take no one's place
  for (WorkerProcess& worker : workers_) {
    if (worker.retired()) continue;
    if (!worker.busy()) return &worker;
    ++there;
  }
  if (there >= options_.workers) return nullptr;
  try {
    ForkedWorker forked = fork_worker(work_, [this] {
      workers_.clear();
      blobs_.clear();
    });
    workers_.emplace_back(next_worker_, std::move(forked));
  } catch (const std::system_error&) {
    if (workers_.empty()) throw;
    return nullptr;  // those there are go on
  }
  ++next_worker_;
  return &workers_.back();
}

void WorkerPool::start_jobs() {
  while (!queue_.empty()) {
    WorkerProcess* worker = free_worker();
    if (worker == nullptr) return;
    Queued next = std::move(queue_.front());
    queue_.pop_front();
    worker->start(next.id, std::move(next.job), next.limits);
  }
}

std::vector<FinishedJob> WorkerPool::wait(std::chrono::milliseconds at_most) {
  const Clock::time_point start = Clock::now(), end = start + at_most;
  if (!workers_.empty()) poll_until(start);  // an idle worker that is gone must not be given a job
  bool interrupted = false;
  for (;;) {
    start_jobs();
    if (!finished_.empty() || interrupted || idle()) break;
    if (Clock::now() >= end) break;
    interrupted = !poll_until(next_check(end));
    check_limits();
  }
  return std::exchange(finished_, {});
}

Clock::time_point WorkerPool::next_check(Clock::time_point end) const {
  for (const WorkerProcess& worker : workers_) {
    if (const auto deadline = worker.deadline()) end = std::min(end, *deadline);
    if (worker.memory_limited()) end = std::min(end, Clock::now() + memory_interval);
  }
  return end;
}

// Serves the workers that have something to tell, if there are any until `end`. False where a signal came.
bool WorkerPool::poll_until(Clock::time_point end) {
  std::vector<pollfd> watched;
  for (const WorkerProcess& worker : workers_) {
    watched.push_back({worker.process(), POLLIN, 0});
    watched.push_back({worker.socket(), short(POLLIN | (worker.sending() ? POLLOUT : 0)), 0});
    watched.push_back({worker.errors(), POLLIN, 0});  // a closed one is -1, which poll passes over
  }
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
  const int count =
      poll(watched.data(), watched.size(), int(std::clamp<std::int64_t>(left.count(), 0, 60'000)));
  if (count < 0) {
    if (errno == EINTR) return false;
    throw std::system_error(errno, std::generic_category(), "poll");
  }
  // Backwards, because those that have ended are taken out.
  for (std::size_t i = workers_.size(); i-- > 0;) {
    const pollfd* its = &watched[3 * i];
    if (its[2].revents != 0) workers_[i].read_errors();
    if (its[1].revents & POLLOUT) workers_[i].flush();
    if (its[1].revents & ~POLLOUT) serve(workers_[i]);
    if (its[0].revents != 0) bury(i);
  }
  return true;
}

void WorkerPool::serve(WorkerProcess& worker) {
  while (std::optional<Message> message = worker.receive()) obey(worker, std::move(*message));
}

void WorkerPool::obey(WorkerProcess& worker, Message message) {
  switch (message.kind) {
    case MessageKind::answer:
    case MessageKind::out_of_memory:
    case MessageKind::failed:
      if (!worker.busy()) return;
      finished_.push_back(worker.finish(std::move(message)));
      if (options_.jobs_per_worker > 0 && worker.jobs_done() >= options_.jobs_per_worker) worker.kill();
      return;
    case MessageKind::blob_wanted:
      worker.stop_clock();
      return tell(blobs_.wanted(worker.id(), message.body));
    case MessageKind::blob_made:
    case MessageKind::blob_not_made:
      return tell(blobs_.made(worker.id(), message.body, std::move(message.descriptor)));
    case MessageKind::job:
    case MessageKind::figures:
    case MessageKind::blob_here:
    case MessageKind::blob_make:
      return;  // never from a worker
  }
}

void WorkerPool::tell(std::vector<BlobBroker::Reply> replies) {
  for (BlobBroker::Reply& reply : replies) {
    const auto found = std::find_if(workers_.begin(), workers_.end(),
                                    [&](const WorkerProcess& worker) { return worker.id() == reply.worker; });
    if (found == workers_.end()) continue;
    found->go_on();
    Message message;
    message.kind = reply.blob ? MessageKind::blob_here : MessageKind::blob_make;
    message.descriptor = std::move(reply.blob);
    found->send(std::move(message));
  }
}

void WorkerPool::check_limits() {
  const Clock::time_point now = Clock::now();
  for (WorkerProcess& worker : workers_) {
    worker.check_time(now);
    worker.check_memory();
  }
}

// Takes out the worker at `index`, which has ended.
void WorkerPool::bury(std::size_t index) {
  serve(workers_[index]);  // it may have answered before
  if (std::optional<FinishedJob> result = workers_[index].bury()) finished_.push_back(std::move(*result));
  const int id = workers_[index].id();
  workers_.erase(workers_.begin() + std::ptrdiff_t(index));
  tell(blobs_.gone(id));
}

void WorkerPool::stop() {
  for (WorkerProcess& worker : workers_) worker.kill();
  for (WorkerProcess& worker : workers_) worker.bury();
  workers_.clear();
  queue_.clear();
  finished_.clear();
  blobs_.forget_workers();
}

}  // namespace trace
