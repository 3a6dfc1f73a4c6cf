// Pictures that the UW course's sample solution drew, 300 pixels wide with three bounces. They are other
// people's and not part of the project: ../shared/corpus where it is present.
#include <catch2/catch.hpp>

#include <map>

#include "tests/support/picture_table.hpp"

namespace trace::test {
namespace {

const std::filesystem::path samples = std::filesystem::path(TRACE_SOURCE_DIR) / "../shared/corpus/uw_samples";

// Pixels that differ by more than one level (docs/results/uw-dialect.md); of other pictures none does.
const std::map<std::string, std::size_t> beyond_a_level{
    {"simple/cube_transparent", 1},
    {"simple/trimesh_cube", 1},
    {"trimeshes/z-polytest", 1},
};

}  // namespace

TEST_CASE("uw draws the 37 samples of its course with less than one pixel in a hundred off by over a level") {
  if (!std::filesystem::exists(samples / "scenes")) {
    WARN("skipped: the corpus is not at ../shared/corpus");
    return;
  }
  const TemporaryFolder scratch;
  const std::string output = (scratch.path() / "out.png").string();
  std::size_t drawn = 0, identical = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(samples / "scenes")) {
    if (entry.path().extension() != ".ray") continue;
    const std::string name =
        entry.path().lexically_relative(samples / "scenes").replace_extension("").generic_string();
    INFO(name);
    const Outcome outcome =
        run_trace(samples, "-q --dialect uw -r 3 -w 300", {entry.path().string(), output});
    REQUIRE(outcome.status == 0);
    const Difference difference =
        compare(read_image(output), read_image(samples / "solutions" / (name + ".png")));
    const auto found = beyond_a_level.find(name);
    CHECK(difference.over_a_level <= (found == beyond_a_level.end() ? 0 : found->second));
    CHECK(difference.over_a_level * 100 < difference.total);
    ++drawn;
    identical += difference.pixels == 0;
  }
  CHECK(drawn == 37);
  CHECK(identical >= 34);
}

}  // namespace trace::test
