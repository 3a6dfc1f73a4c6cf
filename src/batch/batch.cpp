#include "batch/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <map>

#include "batch/failure.hpp"
#include "batch/fingerprint.hpp"
#include "batch/run_job.hpp"
#include "batch/signal_watch.hpp"
#include "process/worker_pool.hpp"

namespace trace {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

// The latest record of each job by scene and renderer.
using Earlier = std::map<std::pair<std::string, std::string>, const Record*>;

Earlier latest(const std::vector<Record>& records) {
  Earlier result;
  for (const Record& record : records) {
    const auto scene = record.find("scene"), renderer = record.find("renderer");
    if (scene != record.end() && renderer != record.end() && scene->is_string() && renderer->is_string())
      result[{scene->get<std::string>(), renderer->get<std::string>()}] = &record;
  }
  return result;
}

class BatchRunner {
 public:
  BatchRunner(const std::vector<Job>& jobs, int workers, Journal& journal, BatchObserver& observer)
      : jobs_(jobs), workers_(workers), journal_(journal), observer_(observer), records_(jobs.size()) {}

  BatchRun run() {
    find_finished();
    sort_by_expected_time();
    work();
    for (Record& record : records_) {
      if (!record.is_null()) result_.records.push_back(std::move(record));
    }
    return std::move(result_);
  }

 private:
  // Splits the jobs into those that are done, those to be compared only, and those to be drawn.
  void find_finished() {
    const Earlier earlier = latest(journal_.earlier());
    FileHashes files;
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      Job& job = jobs_[i];
      const auto known = earlier.find({job.name, job.renderer.name});
      if (known == earlier.end()) {
        to_do_.push_back(i);
        continue;
      }
      const Record& record = *known->second;
      expected_seconds_[i] = record.value("seconds", 0.0);
      if (!picture_is_current(record, job, program_, files)) {
        to_do_.push_back(i);
      } else if (!comparison_is_current(record, job, files)) {
        job.finished = record;
        to_do_.push_back(i);
      } else {
        records_[i] = record;
        place(job, records_[i]);
        ++result_.resumed;
      }
    }
  }

  // Long ones first, so that at the end no worker waits long for another: by the time an earlier run took, or
  // else by the size of the file, with a cost a byte that is typical of meshes.
  void sort_by_expected_time() {
    for (const std::size_t i : to_do_) {
      if (expected_seconds_.count(i)) continue;
      std::error_code error;
      const auto size = std::filesystem::file_size(jobs_[i].scene, error);
      expected_seconds_[i] = error ? 0 : 1e-7 * static_cast<double>(size);
    }
    std::stable_sort(to_do_.begin(), to_do_.end(), [&](std::size_t a, std::size_t b) {
      return expected_seconds_.at(a) > expected_seconds_.at(b);
    });
  }

  void work() {
    status_.total = to_do_.size();
    if (to_do_.empty()) return;
    // A few jobs on many processors: the threads of each make up for it.
    const int at_a_time = static_cast<int>(std::min(to_do_.size(), static_cast<std::size_t>(workers_)));
    for (const std::size_t i : to_do_) jobs_[i].options.threads = std::max(1, workers_ / at_a_time);

    const SignalWatch signals;
    WorkerPool pool(at_a_time, [this](std::string_view text, BlobExchange& blobs) {
      std::size_t i = 0;
      std::from_chars(text.data(), text.data() + text.size(), i);
      return run_job(jobs_[i], program_, blobs)
          .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    });
    for (const std::size_t i : to_do_) pool.submit(i, fmt::format("{}", i), worker_limits(jobs_[i]));
    while (!pool.idle()) {
      for (const FinishedJob& finished : pool.wait(100ms)) take(finished);
      report_status(pool);
      result_.signal = signals.pending();
      if (result_.signal != 0) break;
    }
    pool.stop();
  }

  void take(const FinishedJob& finished) {
    const Job& job = jobs_[finished.id];
    Record record = finished.outcome.kind == Outcome::Kind::answered
                        ? Record::parse(finished.answer, nullptr, false)
                        : Record();
    if (!record.is_object()) record = failure_record(job, finished);
    if (job.renderer.command.empty() && job.finished.is_null())
      record["memory_mib"] = static_cast<double>(finished.peak_memory_bytes) / (1 << 20);
    journal_.append(record);
    ++status_.done;
    status_.failures += is_failure(record);
    if (record["rays"].is_number() && job.finished.is_null())
      status_.rays += record["rays"].get<std::uint64_t>();
    update_time();
    observer_.finished(record, status_);
    records_[finished.id] = std::move(record);
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
  BatchObserver& observer_;
  const std::string program_ = own_program_hash();
  const Clock::time_point begin_ = Clock::now();
  std::vector<std::size_t> to_do_;
  std::map<std::size_t, double> expected_seconds_;
  std::vector<Record> records_;
  BatchStatus status_;
  BatchRun result_;
};

}  // namespace

BatchRun run_batch(const std::vector<Job>& jobs, int workers, Journal& journal, BatchObserver& observer) {
  return BatchRunner(jobs, workers, journal, observer).run();
}

bool is_failure(const Record& record) {
  if (record.at("outcome") != outcome::rendered) return true;
  const Record& comparison = record.at("comparison");
  if (comparison.is_null()) return false;
  const Record& verdict = comparison.at("verdict");
  return verdict != name(Verdict::identical) && verdict != name(Verdict::within);
}

}  // namespace trace
