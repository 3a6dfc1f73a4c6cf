#include "batch/tables.hpp"

#include <fmt/format.h>

#include "batch/batch.hpp"
#include "batch/run_job.hpp"
#include "report/csv.hpp"
#include "report/junit.hpp"

namespace trace {
namespace {

// The member behind a path of names; null where there is none.
const Record& member(const Record& record, std::initializer_list<const char*> path) {
  static const Record none;
  const Record* at = &record;
  for (const char* name : path) {
    const auto found = at->is_object() ? at->find(name) : at->end();
    if (!at->is_object() || found == at->end()) return none;
    at = &*found;
  }
  return *at;
}

std::string field(const Record& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace

std::string batch_csv(const Record& summary) {
  std::string text = csv_row({"scene", "renderer", "outcome", "verdict", "reason", "diagnosis", "rmse",
                              "largest", "percent_over_one", "ssim", "flip", "seconds", "cpu_seconds",
                              "memory_mib", "rays", "message"});
  for (const Record& record : summary.at("results")) {
    const Record& comparison = record.at("comparison");
    text += csv_row({field(record.at("scene")), field(record.at("renderer")), field(record.at("outcome")),
                     field(member(comparison, {"verdict"})), field(member(comparison, {"reason"})),
                     field(member(comparison, {"diagnosis", "text"})),
                     field(member(comparison, {"measurements", "root_mean_square"})),
                     field(member(comparison, {"measurements", "largest", "difference"})),
                     field(member(comparison, {"measurements", "percent_over_one"})),
                     field(member(comparison, {"measurements", "ssim"})),
                     field(member(comparison, {"measurements", "flip"})), field(record.at("seconds")),
                     field(record.at("cpu_seconds")), field(record.at("memory_mib")),
                     field(record.at("rays")), field(record.at("message"))});
  }
  return text;
}

std::string batch_junit(const Record& summary) {
  const bool several = summary.at("renderers").size() > 1;
  std::vector<JUnitCase> cases;
  for (const Record& record : summary.at("results")) {
    JUnitCase result;
    result.name = field(record.at("scene"));
    result.group = several ? field(record.at("renderer")) : field(summary.at("title"));
    result.seconds = record.at("seconds").get<double>();
    if (record.at("outcome") != outcome::rendered) {
      result.outcome = JUnitCase::Outcome::error;
      result.type = field(record.at("outcome"));
      result.details = field(record.at("message"));
      result.message = result.details.substr(0, result.details.find('\n'));
    } else if (is_failure(record)) {
      const Record& comparison = record.at("comparison");
      result.outcome = JUnitCase::Outcome::failure;
      result.type = field(comparison.at("verdict"));
      result.message = field(comparison.at("reason"));
      result.details = field(member(comparison, {"diagnosis", "text"}));
    }
    cases.push_back(std::move(result));
  }
  return junit_xml("trace batch", cases);
}

}  // namespace trace
