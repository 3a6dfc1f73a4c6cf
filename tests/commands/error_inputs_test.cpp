// The inputs that the reference refuses, through the whole program: message and exit status of each, and no
// picture.
#include <catch2/catch.hpp>

#include "tests/support/picture_table.hpp"

namespace trace::test {
namespace {

const std::filesystem::path tests = std::filesystem::path(TRACE_SOURCE_DIR) / "tests";

// "\n" for a line end, as the tables write it.
std::string unescaped(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && i + 1 < text.size()) {
      ++i;
      result += text[i] == 'n' ? '\n' : text[i];
    } else {
      result += text[i];
    }
  }
  return result;
}

}  // namespace

// Eight of the 37 are accepted on purpose: a sign or E in numbers, a stray ';' or `material =` in a group, 'name ='
// in a material,
// references to named materials (docs/differences.md).
TEST_CASE("each of the 37 error inputs has its message and exit status, and leaves no picture") {
  const TemporaryFolder scratch;
  const std::filesystem::path output = scratch.path() / "out.png";
  std::size_t refused = 0;
  const auto rows = read_table(tests / "picture_cases/error_messages.tsv");
  CHECK(rows.size() == 37);
  for (const auto& row : rows) {
    INFO(row[0]);
    std::filesystem::remove(output);
    const Outcome outcome = run_trace(tests / "picture_cases", row[1], {row[0], output.string()});
    CHECK(outcome.status == std::stoi(row[2]));
    CHECK(outcome.errors == (row.size() > 3 ? unescaped(row[3]) : ""));
    CHECK(outcome.output.empty());
    CHECK(std::filesystem::exists(output) == (outcome.status == 0));
    refused += outcome.status == 1;
  }
  CHECK(refused == 29);
}

TEST_CASE("each language case is drawn or refused by the program as its verdict says") {
  const TemporaryFolder scratch;
  const std::filesystem::path output = scratch.path() / "out.png";
  const auto rows = read_table(tests / "language_cases/verdicts.tsv");
  CHECK(rows.size() == 212);
  for (const auto& row : rows) {
    INFO(row[0]);
    std::filesystem::remove(output);
    const Outcome outcome = run_trace(tests / "language_cases", "-w 8", {row[0], output.string()});
    const bool refused = row[2] == "rejects" || (row[2] == "scene" && row.size() > 3 && !row[3].empty());
    CHECK(outcome.status == (refused ? 1 : 0));
    CHECK(std::filesystem::exists(output) == !refused);
    if (refused) {
      CHECK_THAT(outcome.errors, Catch::StartsWith(row[0] + ":"));
      CHECK_THAT(outcome.errors, Catch::Contains(row[3]));
    }
  }
}

}  // namespace trace::test
