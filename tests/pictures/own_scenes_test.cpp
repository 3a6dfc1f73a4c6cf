// The project's own scenes, in scenes/, and their solution pictures.
#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/support/picture_table.hpp"

namespace trace::test {
namespace {

const std::filesystem::path scenes = std::filesystem::path(TRACE_SOURCE_DIR) / "scenes";

}  // namespace

TEST_CASE("every scene of ours is its solution picture, byte for byte") {
  const TemporaryFolder scratch;
  const std::string output = (scratch.path() / "out.png").string();
  const auto rows = read_table(scenes / "manifest.tsv");
  CHECK(rows.size() >= 20);
  for (const auto& row : rows) {
    INFO(row[0]);
    const Outcome outcome = run_trace(scenes, row[1], {row[0], output});
    CHECK(outcome.errors.empty());
    REQUIRE(outcome.status == 0);
    CHECK(compare(read_image(output), read_image(scenes / row[2])).pixels == 0);
  }
}

TEST_CASE("every scene in the folder has a solution") {
  const auto rows = read_table(scenes / "manifest.tsv");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scenes)) {
    if (entry.path().extension() != ".ray") continue;
    const std::string name = std::filesystem::relative(entry.path(), scenes).string();
    INFO(name);
    CHECK(std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row[0] == name; }));
  }
}

TEST_CASE("the same bytes come of any number of threads") {
  const TemporaryFolder scratch;
  const std::string one = (scratch.path() / "one.png").string(),
                    many = (scratch.path() / "many.png").string();
  for (const auto& row : read_table(scenes / "manifest.tsv")) {
    if (row[0].rfind("features/", 0) != 0) continue;  // the small ones
    INFO(row[0]);
    REQUIRE(run_trace(scenes, row[1] + " -t 1", {row[0], one}).status == 0);
    REQUIRE(run_trace(scenes, row[1] + " -t 5", {row[0], many}).status == 0);
    CHECK(read_text(one) == read_text(many));
  }
}

}  // namespace trace::test
