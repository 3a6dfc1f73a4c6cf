// The course's own and its students' scenes with the pictures of the reference renderer. They are other
// people's and not part of the project: ../shared/corpus where it is present.
#include <catch2/catch.hpp>

#include <map>

#include "tests/support/picture_table.hpp"

namespace trace::test {
namespace {

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

TEST_CASE("every corpus scene that the reference refuses is an error or a scene of ours without one crash") {
  if (!std::filesystem::exists(corpus / "manifest.tsv")) {
    WARN("skipped: the corpus is not at ../shared/corpus");
    return;
  }
  const TemporaryFolder scratch;
  const std::string output = (scratch.path() / "out.png").string();
  for (const auto& row : read_table(corpus / "manifest.tsv")) {
    if (row[3] != "rejects") continue;
    INFO(row[0]);
    const Outcome outcome = run_trace(corpus, "-w 16", {row[0], output});
    CHECK((outcome.status == 0 || outcome.status == 1));
    if (outcome.status == 1) CHECK_THAT(outcome.errors, Catch::Contains(": error: "));
  }
}

}  // namespace trace::test
