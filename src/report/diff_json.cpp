#include "report/diff_json.hpp"

#include "report/comparison_json.hpp"
#include "report/plain_text.hpp"

namespace trace {
namespace {

using json = nlohmann::ordered_json;

json path(const std::optional<std::string>& file) {
  return file ? json(valid_utf8(*file)) : json();
}

json pair(const ComparedPair& compared) {
  json result = {{"name", valid_utf8(compared.name)},
                 {"reference", path(compared.reference)},
                 {"test", path(compared.test)}};
  result.update(comparison_json(compared.judgement));
  return result;
}

}  // namespace

std::string diff_json(const DiffReport& report) {
  json result = {{"format", "trace-diff"},
                 {"version", 1},
                 {"reference", valid_utf8(report.reference)},
                 {"test", valid_utf8(report.test)},
                 {"status", report.status()}};
  json& counts = result["counts"] = json::object();
  for (const Verdict verdict : all_verdicts) counts[std::string(name(verdict))] = report.count(verdict);
  json& pairs = result["pairs"] = json::array();
  for (const ComparedPair& compared : report.pairs) pairs.push_back(pair(compared));
  return result.dump(1) + "\n";
}

}  // namespace trace
