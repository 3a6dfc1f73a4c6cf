#include "batch/summary.hpp"

#include <set>

#include "batch/run_job.hpp"
#include "report/diff_report.hpp"

namespace trace {
namespace {

Record counts(const std::vector<Record>& records) {
  std::set<std::string> scenes;
  std::size_t rendered = 0, failed = 0, uncompared = 0;
  Record result = {{"scenes", 0}, {"rendered", 0}, {"failed", 0}};
  for (const Verdict verdict : all_verdicts) result[std::string(name(verdict))] = 0;
  for (const Record& record : records) {
    scenes.insert(record.at("scene").get<std::string>());
    const bool done = record.at("outcome") == outcome::rendered;
    (done ? rendered : failed) += 1;
    if (const Record& comparison = record.at("comparison"); !comparison.is_null()) {
      Record& count = result[comparison.at("verdict").get<std::string>()];
      count = count.get<int>() + 1;
    } else if (done) {
      ++uncompared;
    }
  }
  result["scenes"] = scenes.size();
  result["rendered"] = rendered;
  result["failed"] = failed;
  result["not_compared"] = uncompared;
  return result;
}

}  // namespace

Record summary(const BatchInfo& info, const BatchRun& run) {
  Record results = Record::array();
  for (const Record& record : run.records) {
    Record& result = results.emplace_back(record);
    for (const char* internal : internal_members) result.erase(internal);
  }
  return {{"format", "trace-batch"},
          {"version", 1},
          {"title", info.title},
          {"command", info.command},
          {"started", info.started},
          {"seconds", info.seconds},
          {"interrupted", run.signal != 0},
          {"renderers", info.renderers},
          {"counts", counts(run.records)},
          {"results", std::move(results)}};
}

int batch_exit_status(const Record& summary) {
  bool beyond = false;
  for (const Record& record : summary.at("results")) {
    if (record.at("outcome") != outcome::rendered) return 3;
    beyond |= is_failure(record);
  }
  return beyond ? 1 : 0;
}

}  // namespace trace
