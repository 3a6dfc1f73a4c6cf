// 312 small scenes and the pictures that the course's reference renderer drew of them, in
// tests/picture_cases.
#include <catch2/catch.hpp>

#include <map>

#include "tests/support/picture_table.hpp"

namespace trace::test {
namespace {

const std::filesystem::path folder = std::filesystem::path(TRACE_SOURCE_DIR) / "tests/picture_cases";

// The three that are not drawn the same, on purpose (docs/differences.md).
const std::map<std::string, std::string> refused{
    {"parse_num12.ray",
     "parse_num12.ray:3:31: error: malformed number '0.5-2'\n"
     "square { material={ emissive=(0.5-2,0,0);} }\n"
     "                              ^~~~~\n"},
    {"parse_fracidx.ray",
     "parse_fracidx.ray:3:58: error: face index 1.7 is not a whole number\n"
     "trimesh { points=((-1,-1,0),(1,-1,0),(0,1,0)); faces=((0,1.7,2.2)); material={ emissive=(1,0,0); } }\n"
     "                                                         ^~~\n"}};
// The reference shows the blue of a BMP's second row from the bottom as its green where 3 w mod 4 is 3.
const std::string reference_misreads_bmp = "texmap_tex_5x3_bmp.ray";

}  // namespace

TEST_CASE("every picture case is the reference's picture, byte for byte") {
  const TemporaryFolder scratch;
  const std::string output = (scratch.path() / "out.png").string();
  std::size_t identical = 0;
  for (const auto& row : read_table(folder / "manifest.tsv")) {
    REQUIRE(row.size() >= 3);
    INFO(row[0]);
    const Outcome outcome = run_trace(folder, "-q " + row[1], {row[0], output});
    if (const auto found = refused.find(row[0]); found != refused.end()) {
      CHECK(outcome.status == 1);
      CHECK_THAT(outcome.errors, Catch::StartsWith(found->second));
      continue;
    }
    CHECK(outcome.errors.empty());
    REQUIRE(outcome.status == 0);
    const Difference difference = compare(read_image(output), read_image(folder / row[2]));
    if (row[0] == reference_misreads_bmp) {
      CHECK(difference.pixels > 0);  // of blue alone; the PNG of the same texture is identical
    } else {
      CHECK(difference.pixels == 0);
      identical += difference.pixels == 0;
    }
  }
  CHECK(identical == 309);
}

}  // namespace trace::test
