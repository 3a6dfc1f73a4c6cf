// The course's own and its students' scenes with the pictures of the reference renderer. They are other
// people's and not part of the project: ../shared/corpus where it is present.
#include <catch2/catch.hpp>

#include <map>

#include "tests/support/picture_table.hpp"

namespace trace::test {
namespace {

const std::filesystem::path tests = std::filesystem::path(TRACE_SOURCE_DIR) / "tests";
const std::filesystem::path corpus = std::filesystem::path(TRACE_SOURCE_DIR) / "../shared/corpus";

// Pixels that differ, none by more than one level.
const std::map<std::string, std::size_t> known{{"scenes/student/mbartling+photonMapper/easy3a.ray", 1}};

std::size_t allowed(const std::string& scene) {
  const auto found = known.find(scene);
  return found == known.end() ? 0 : found->second;
}

}  // namespace

TEST_CASE("every corpus scene is the reference's picture, byte for byte but for one pixel") {
  if (!std::filesystem::exists(corpus / "manifest.tsv")) {
    WARN("skipped: the corpus is not at ../shared/corpus");
    return;
  }
  const TemporaryFolder scratch;
  const std::string output = (scratch.path() / "out.png").string();
  std::size_t rendered = 0;
  for (const auto& row : read_table(corpus / "manifest.tsv")) {
    if (row[2] == "-") continue;
    INFO(row[0] << " " << row[1]);
    const Outcome outcome = run_trace(corpus, "-q " + row[1], {row[0], output});
    CHECK(outcome.errors.empty());
    REQUIRE(outcome.status == 0);
    const Difference difference = compare(read_image(output), read_image(corpus / row[2]));
    CHECK(difference.pixels <= allowed(row[0]));
    CHECK(difference.over_a_level == 0);
    ++rendered;
  }
  CHECK(rendered == 205);
}

TEST_CASE("every corpus scene is drawn or refused as the table says, strictly and permissively") {
  if (!std::filesystem::exists(corpus / "manifest.tsv")) {
    WARN("skipped: the corpus is not at ../shared/corpus");
    return;
  }
  const TemporaryFolder scratch;
  const std::string output = (scratch.path() / "out.png").string();
  std::map<std::string, std::size_t> counts;
  for (const auto& row : read_table(tests / "pictures/corpus_verdicts.tsv")) {
    INFO(row[0]);
    const bool strictly = row[2] == "renders", permissively = row[3] == "renders";
    const Outcome strict = run_trace(corpus, "-r 1 -w 16", {row[0], output});
    CHECK(strict.status == (strictly ? 0 : 1));
    if (!strictly) CHECK_THAT(strict.errors, Catch::StartsWith(row[0] + ":" + row[4] + "\n"));
    if (!strictly) {
      const Outcome permissive = run_trace(corpus, "-r 1 -w 16 --permissive", {row[0], output});
      CHECK(permissive.status == (permissively ? 0 : 1));
      CHECK_THAT(permissive.errors, Catch::Contains(permissively ? ": warning: " : ": error: "));
    }
    // Where we differ from the reference the table says why.
    CHECK((row[1] == row[2] || (row[1] == "rejects" && row[2] == "refused")) ==
          (row.size() < 6 || row[5].empty()));
    ++counts[row[2]];
    ++counts[row[3] + " with --permissive"];
  }
  CHECK(counts["renders"] == 255);
  CHECK(counts["renders with --permissive"] == 285);
}

}  // namespace trace::test
