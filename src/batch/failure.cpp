#include "batch/failure.hpp"

#include <fmt/format.h>

#include "batch/run_job.hpp"

namespace trace {

Limits worker_limits(const Job& job) {
  Limits limits = job.limits;
  if (job.renderer.command.empty()) return limits;
  constexpr std::chrono::seconds to_look{60};  // at the largest pictures there are
  constexpr std::uint64_t memory_to_look = std::uint64_t{4} << 30;
  if (limits.timeout.count() > 0) limits.timeout += to_look;
  if (limits.memory_bytes > 0) limits.memory_bytes = std::max(limits.memory_bytes, memory_to_look);
  return limits;
}

const char* outcome_word(const Outcome& outcome) {
  switch (outcome.kind) {
    case Outcome::Kind::signalled:
      return outcome::crashed;
    case Outcome::Kind::timed_out:
      return outcome::timeout;
    case Outcome::Kind::out_of_memory:
      return outcome::memory;
    default:
      return outcome::failed;
  }
}

std::string failure_message(const Job& job, const Outcome& outcome) {
  std::string reason;
  switch (outcome.kind) {
    case Outcome::Kind::timed_out:
      reason = fmt::format("not done after {} s, the limit of time for one scene (--timeout)",
                           job.limits.timeout.count());
      break;
    case Outcome::Kind::out_of_memory:
      reason = fmt::format("needs more than {} MiB, the limit of memory for one scene (--memory)",
                           job.limits.memory_bytes >> 20);
      break;
    default: {
      const std::string who = job.renderer.command.empty() ? "trace" : job.renderer.name;
      reason = fmt::format("{} {}", who, text(outcome));
    }
  }
  return fmt::format("{}: error: {}\n", job.scene, reason);
}

Record failure_record(const Job& job, const FinishedJob& finished) {
  Record record = new_record(job);
  record["outcome"] = outcome_word(finished.outcome);
  record["message"] = failure_message(job, finished.outcome) + finished.errors;
  record["seconds"] = finished.seconds;
  record["cpu_seconds"] = finished.cpu_seconds;
  record["memory_mib"] = static_cast<double>(finished.peak_memory_bytes) / (1 << 20);
  std::error_code ignored;
  std::filesystem::remove(job.picture, ignored);
  if (!job.heat_map.empty()) std::filesystem::remove(job.heat_map, ignored);
  place(job, record);
  return record;
}

}  // namespace trace
