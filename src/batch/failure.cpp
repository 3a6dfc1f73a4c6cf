#include "batch/failure.hpp"

#include <fmt/format.h>

#include "batch/run_job.hpp"
#include "report/comparison_json.hpp"

namespace trace {

Limits drawing_limits(const Job& job) {
  if (job.renderer.command.empty()) return job.limits;
  Limits limits = comparing_limits();  // it looks at the picture
  if (job.limits.timeout.count() > 0) limits.timeout += job.limits.timeout;
  return limits;
}

Limits comparing_limits() {
  constexpr std::chrono::seconds to_look{60};
  constexpr std::uint64_t memory_to_look = std::uint64_t{6} << 30;
  return {to_look, memory_to_look};
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

std::string failure_message(const Job& job, const std::string& who, const Outcome& outcome) {
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
    default:
      reason = fmt::format("{} {}", who, text(outcome));
  }
  return fmt::format("{}: error: {}\n", job.scene, reason);
}

Record failure_record(const Job& job, const FinishedJob& finished) {
  Record record = new_record(job);
  record["outcome"] = outcome_word(finished.outcome);
  record["message"] = failure_message(job, "trace", finished.outcome) + finished.errors;
  record["seconds"] = finished.seconds;
  record["cpu_seconds"] = finished.cpu_seconds;
  record["memory_mib"] = static_cast<double>(finished.peak_memory_bytes) / (1 << 20);
  std::error_code ignored;
  if (job.has_old_picture) std::filesystem::remove(job.picture, ignored);
  if (!job.heat_map.empty()) std::filesystem::remove(job.heat_map, ignored);
  place(job, record);
  return record;
}

void set_comparison_failure(const Job& job, const FinishedJob& finished, Record& record) {
  Judgement judgement;
  judgement.verdict = Verdict::unreadable;
  judgement.reason = fmt::format("the comparison {}", text(finished.outcome));
  judgement.tolerance = job.tolerance;
  record["comparison"] = comparison_json(judgement);
  record["judge_key"] = nullptr;  // the next run tries again
}

}  // namespace trace
