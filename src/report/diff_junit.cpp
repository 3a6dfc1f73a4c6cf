#include "report/diff_junit.hpp"

#include <fmt/format.h>

#include "report/junit.hpp"

namespace trace {
namespace {

constexpr const char* suite_name = "trace diff";

std::string details(const ComparedPair& pair) {
  std::string text;
  if (pair.reference) text += fmt::format("reference {}\n", *pair.reference);
  if (pair.test) text += fmt::format("test      {}\n", *pair.test);
  if (pair.judgement.diagnosis) text += fmt::format("diagnosis {}\n", pair.judgement.diagnosis->text);
  if (pair.judgement.measurements) {
    const Measurements& m = *pair.judgement.measurements;
    text += fmt::format("RMSE {:.3g}, largest {:.4g} at ({}, {}), {:.3g} % of pixels over 1 level\n",
                        m.error.root_mean_square, m.error.largest, m.largest.pixel.x, m.largest.pixel.y,
                        m.percent_over_one);
  }
  return text;
}

JUnitCase test_case(const ComparedPair& pair) {
  JUnitCase result;
  const std::size_t slash = pair.name.rfind('/');
  result.group = slash == pair.name.npos ? suite_name : pair.name.substr(0, slash);
  result.name = slash == pair.name.npos ? pair.name : pair.name.substr(slash + 1);
  const int status = exit_status(pair.judgement.verdict);
  if (status == 0) return result;
  result.outcome = status < 3 ? JUnitCase::Outcome::failure : JUnitCase::Outcome::error;
  result.type = name(pair.judgement.verdict);
  result.message = pair.judgement.reason.empty() ? result.type : pair.judgement.reason;
  result.details = details(pair);
  return result;
}

}  // namespace

std::string diff_junit(const DiffReport& report) {
  std::vector<JUnitCase> cases;
  for (const ComparedPair& pair : report.pairs) cases.push_back(test_case(pair));
  return junit_xml(suite_name, cases);
}

}  // namespace trace
