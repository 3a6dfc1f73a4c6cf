// The small scenes that were measured on the course's renderer, each with our verdict: verdicts.tsv.
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>
#include <vector>

#include "helpers.hpp"

using namespace trace::parser;

namespace {

const std::string folder = std::string(TRACE_SOURCE_DIR) + "/tests/language_cases/";

struct Verdict {
  std::string file, reference, ours, message, why;
};

std::vector<Verdict> verdicts() {
  std::ifstream table(folder + "verdicts.tsv");
  std::vector<Verdict> result;
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line)) {
    std::istringstream fields(line + "\t");
    Verdict v;
    for (std::string* field : {&v.file, &v.reference, &v.ours, &v.message, &v.why})
      std::getline(fields, *field, '\t');
    result.push_back(v);
  }
  return result;
}

}  // namespace

TEST_CASE("every language case gets the verdict and the message of the table") {
  const std::vector<Verdict> table = verdicts();
  REQUIRE(table.size() == 212);
  for (const Verdict& verdict : table) {
    INFO(verdict.file);
    const Source source = Source::from_file(folder + verdict.file);
    Diagnostics diagnostics;
    parse(source, diagnostics);
    if (verdict.ours != "rejects") {
      CHECK(render(source, diagnostics).empty());
      continue;
    }
    const std::string report = render(source, diagnostics);
    const std::string prefix = folder + verdict.file + ":";
    REQUIRE(report.substr(0, prefix.size()) == prefix);
    CHECK(report.substr(prefix.size(), report.find('\n') - prefix.size()) == verdict.message);
  }
}

TEST_CASE("every verdict that differs from the reference gives its reason") {
  for (const Verdict& verdict : verdicts()) {
    INFO(verdict.file);
    CHECK((verdict.ours == verdict.reference) == verdict.why.empty());
  }
}
