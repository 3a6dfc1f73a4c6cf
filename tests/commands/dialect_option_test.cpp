// `--dialect`.
#include <catch2/catch.hpp>

#include "tests/support/picture_table.hpp"

namespace trace::test {
namespace {

// A ball that shines, over a floor that a mirror would show.
constexpr const char* dialect_scene =
    "SBT-raytracer 1.0\n// uw\ncamera { position = (0, 0, 3); }\n"
    "directional_light { direction = (-1, -1, -2); color = (1, 1, 1); }\n"
    "sphere { material = { diffuse = (0.2, 0.2, 0.2); specular = (0.7, 0.7, 0.7); shininess = 20; } }\n"
    "translate(0, -2, 0, scale(9, 1, 9, box { material = { diffuse = (0.2, 0.5, 0.2); } }))\n";

struct DialectDesk {
  TemporaryFolder folder;
  DialectDesk() { write_text(folder / "a.ray", dialect_scene); }
  Image picture(const std::string& arguments) const {
    const Outcome outcome = run_trace(folder.path(), "-q -w 48 " + arguments + " a.ray out.png");
    CHECK(outcome.status == 0);
    return read_image(folder / "out.png");
  }
};

}  // namespace

TEST_CASE("the option --dialect chooses the rules, and without it a scene is drawn by those of utexas") {
  const DialectDesk desk;
  const Image plain = desk.picture("");
  CHECK(compare(plain, desk.picture("--dialect utexas")).pixels == 0);
  const Image uw = desk.picture("--dialect uw"), hkust = desk.picture("--dialect hkust");
  CHECK(compare(plain, uw).over_a_level > 50);
  CHECK(compare(plain, hkust).over_a_level > 50);
  CHECK(compare(uw, hkust).over_a_level > 10);  // their highlights
}

TEST_CASE("a dialect's picture is the same for every set of instructions and every number of threads") {
  const DialectDesk desk;
  for (const std::string dialect : {"--dialect uw", "--dialect hkust"}) {
    const Image picture = desk.picture(dialect);
    CHECK(compare(picture, desk.picture(dialect + " --instruction-set baseline -t 1")).pixels == 0);
    CHECK(compare(picture, desk.picture(dialect + " --model-everything")).pixels == 0);
  }
}

TEST_CASE("an unknown dialect is an error in the command line that names those there are") {
  const DialectDesk desk;
  const Outcome outcome = run_trace(desk.folder.path(), "--dialect cmu a.ray out.png");
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.errors, Catch::Contains("'cmu' is none of utexas, uw, hkust"));
}

TEST_CASE("the commands batch and study take --dialect, and batch draws again where it has changed") {
  const DialectDesk desk;
  const auto batch = [&](const std::string& dialect) {
    const Outcome outcome = run_trace(desk.folder.path(), "batch . -o out -w 48 " + dialect);
    CHECK(outcome.status == 0);
    return read_image(desk.folder / "out/a.png");
  };
  const Image plain = batch(""), uw = batch("--dialect uw");
  CHECK(compare(plain, desk.picture("")).pixels == 0);
  CHECK(compare(uw, desk.picture("--dialect uw")).pixels == 0);
  const auto study = [&](const std::string& dialect) {
    const Outcome outcome = run_trace(
        desk.folder.path(), "study -q -r 1 -w 8 --seconds 0 --axes arithmetic --csv - " + dialect + " a.ray");
    CHECK(outcome.status == 0);
    return outcome.output;
  };
  // Other kinds of arithmetic know utexas alone.
  CHECK_THAT(study(""), Catch::Contains("float"));
  CHECK_THAT(study("--dialect uw"), !Catch::Contains("float"));
}

}  // namespace trace::test
