#include "report/diff_csv.hpp"

#include "report/comparison_csv.hpp"
#include "report/csv.hpp"

namespace trace {
namespace {

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& rest) {
  first.insert(first.end(), rest.begin(), rest.end());
  return first;
}

}  // namespace

std::string diff_csv(const DiffReport& report) {
  std::string result = csv_row(joined({"name", "reference", "test"}, comparison_columns()));
  for (const ComparedPair& pair : report.pairs) {
    result += csv_row(joined({pair.name, pair.reference.value_or(""), pair.test.value_or("")},
                             comparison_fields(pair.judgement)));
  }
  return result;
}

}  // namespace trace
