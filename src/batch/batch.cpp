#include "batch/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <deque>
#include <map>

#include "batch/earlier_results.hpp"
#include "batch/failure.hpp"
#include "batch/foreign_renderer.hpp"
#include "batch/run_job.hpp"
#include "process/worker_pool.hpp"

namespace trace {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

// Without an earlier run a scene's time is guessed from its file: meshes cost about so much a byte.
constexpr double seconds_a_byte = 1e-7;

class BatchRunner {
 public:
  BatchRunner(const std::vector<Job>& jobs, int workers, Journal& journal, const SignalWatch& signals,
              BatchObserver& observer)
      : jobs_(jobs),
        workers_(workers),
        journal_(journal),
        signals_(signals),
        observer_(observer),
        records_(jobs.size()) {}

  BatchRun run() {
    find_what_is_left();
    remove_leftovers(jobs_);
    work();
    journal_.flush();
    for (Record& record : records_) {
      if (!record.is_null()) result_.records.push_back(std::move(record));
    }
    return std::move(result_);
  }

 private:
  void find_what_is_left() {
    EarlierResults earlier(journal_.earlier(), program_);
    std::map<std::size_t, double> seconds;
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      const auto left = earlier.left_of(jobs_[i], records_[i]);
      result_.resumed += left == EarlierResults::Left::nothing;
      if (left == EarlierResults::Left::comparison) to_compare_.push_back(i);
      if (left != EarlierResults::Left::everything) continue;
      to_draw_.push_back(i);
      jobs_[i].has_old_picture = earlier.drew_picture_of(jobs_[i]);
      std::error_code error;
      const auto size = std::filesystem::file_size(jobs_[i].scene, error);
      const double known = earlier.seconds_of(jobs_[i]);
      seconds[i] = known >= 0 ? known : error ? 0 : seconds_a_byte * static_cast<double>(size);
    }
    // Long ones first, so that at the end no worker waits long for another.
    std::stable_sort(to_draw_.begin(), to_draw_.end(),
                     [&](std::size_t a, std::size_t b) { return seconds.at(a) > seconds.at(b); });
  }

  // In a worker. The text is a job's number, and behind it, where it is only to be compared, its record.
  std::string do_job(std::string_view text, BlobExchange& blobs) const {
    std::size_t i = 0;
    const char* end = std::from_chars(text.data(), text.data() + text.size(), i).ptr;
    if (end == text.data() + text.size()) return to_text(draw_job(jobs_[i], program_, blobs));
    Record record = Record::parse(end, text.data() + text.size());
    compare_job(jobs_[i], program_, record);
    return to_text(record);
  }

  void work() {
    status_.total = to_draw_.size() + to_compare_.size();
    if (status_.total == 0) return;
    // A few jobs on many processors: the threads of each make up for it.
    const int at_a_time = static_cast<int>(std::min(status_.total, static_cast<std::size_t>(workers_)));
    for (Job& job : jobs_) job.options.threads = std::max(1, workers_ / at_a_time);
    WorkerPool pool(at_a_time,
                    [this](std::string_view text, BlobExchange& blobs) { return do_job(text, blobs); });
    for (feed(pool); !pool.idle(); feed(pool)) {
      const std::vector<FinishedJob> finished = pool.wait(100ms);
      result_.signal = signals_.pending();
      for (const FinishedJob& job : finished) take(job);
      report_status(pool);
      if (result_.signal != 0) break;
    }
    pool.stop();
    if (result_.signal != 0) remove_leftovers(jobs_);
  }

  // Keeps one job waiting for each worker, comparisons first.
  void feed(WorkerPool& pool) {
    while (pool.queued() < static_cast<std::size_t>(workers_) && !(to_draw_.empty() && to_compare_.empty())) {
      const bool compares = !to_compare_.empty();
      std::deque<std::size_t>& queue = compares ? to_compare_ : to_draw_;
      const std::size_t i = queue.front();
      queue.pop_front();
      std::string text = fmt::format("{}", i);
      if (compares) text += " " + to_text(records_[i]);
      pool.submit(i, std::move(text), compares ? comparing_limits() : drawing_limits(jobs_[i]));
    }
  }

  void take(const FinishedJob& finished) {
    const std::size_t i = finished.id;
    const Job& job = jobs_[i];
    Record& record = records_[i];
    const bool was_drawn = !record.is_null();
    Record answer = finished.answered() ? Record::parse(finished.answer, nullptr, false) : Record();
    if (was_drawn) {
      if (answer.is_object()) {
        record = std::move(answer);
      } else {
        set_comparison_failure(job, finished, record);
      }
    } else {
      record = answer.is_object() ? std::move(answer) : failure_record(job, finished);
      if (record["rays"].is_number()) status_.rays += record["rays"].get<std::uint64_t>();
      if (job.renderer.command.empty())
        record["memory_mib"] = static_cast<double>(finished.peak_memory_bytes) / (1 << 20);
    }
    journal_.append(record);
    if (!was_drawn && record["outcome"] == outcome::rendered && !job.solution.empty()) {
      to_compare_.push_back(i);
      return;
    }
    ++status_.done;
    status_.failures += is_failure(record);
    update_time();
    observer_.finished(record, status_);
  }

  void update_time() {
    status_.seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
    const double share = static_cast<double>(status_.done) / static_cast<double>(status_.total);
    status_.seconds_left = status_.done > 0 ? status_.seconds * (1 - share) / share : -1;
  }

  void report_status(const WorkerPool& pool) {
    update_time();
    status_.running.clear();
    for (const JobId id : pool.running()) status_.running.push_back(jobs_[id].name);
    observer_.tick(status_);
  }

  std::vector<Job> jobs_;
  int workers_;
  Journal& journal_;
  const SignalWatch& signals_;
  BatchObserver& observer_;
  const std::string program_ = own_program_hash();
  const Clock::time_point begin_ = Clock::now();
  std::deque<std::size_t> to_draw_, to_compare_;
  std::vector<Record> records_;  // null as long as there is no picture
  BatchStatus status_;
  BatchRun result_;
};

}  // namespace

BatchRun run_batch(const std::vector<Job>& jobs, int workers, Journal& journal, const SignalWatch& signals,
                   BatchObserver& observer) {
  return BatchRunner(jobs, workers, journal, signals, observer).run();
}

bool is_failure(const Record& record) {
  if (record.at("outcome") != outcome::rendered) return true;
  const Record& comparison = record.at("comparison");
  if (comparison.is_null()) return false;
  const Record& verdict = comparison.at("verdict");
  return verdict != name(Verdict::identical) && verdict != name(Verdict::within);
}

}  // namespace trace
