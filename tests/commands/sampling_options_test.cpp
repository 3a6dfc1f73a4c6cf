// `trace --aa`, `--adaptive`, `--error-budget`, `--time-budget`.
#include <catch2/catch.hpp>
#include <regex>

#include "tests/support/picture_table.hpp"

namespace trace::test {
namespace {

// A ball that mirrors, and pixels on its edge.
constexpr const char* sampled_scene =
    "SBT-raytracer 1.0\ncamera { position = (0, 0, 3); }\n"
    "directional_light { direction = (-1, -1, -2); color = (1, 1, 1); }\n"
    "sphere { material = { diffuse = (0.8, 0.4, 0.2); reflective = (0.3, 0.3, 0.3); } }\n"
    "translate(0, -2, 0, scale(9, 1, 9, box { material = { diffuse = (0.5, 0.5, 0.5); } }))\n";

struct SamplingDesk {
  TemporaryFolder folder;
  SamplingDesk() { write_text(folder / "a.ray", sampled_scene); }
  Outcome trace(const std::string& arguments) const { return run_trace(folder.path(), arguments); }
  bool has(const std::string& file) const { return std::filesystem::exists(folder / file); }
  // Rays from the camera, as the statistics have them.
  std::string primary(const std::string& arguments) const {
    const Outcome outcome = trace("--stats -w 16 " + arguments + " a.ray out.png");
    std::smatch found;
    return std::regex_search(outcome.errors, found, std::regex("([0-9]+) primary")) ? found[1].str() : "";
  }
};

}  // namespace

TEST_CASE("the option --aa takes so many samples squared in every pixel, and one is the course's picture") {
  const SamplingDesk desk;
  CHECK(desk.primary("--aa 2") == "1024");
  CHECK(desk.primary("--aa 3") == "2304");
  CHECK(desk.primary("--aa 1") == "256");
  const Image one = read_image(desk.folder / "out.png");
  REQUIRE(desk.trace("-w 16 a.ray plain.png").errors == "");
  CHECK(compare(one, read_image(desk.folder / "plain.png")).pixels == 0);
  REQUIRE(desk.trace("-w 16 --aa 2 a.ray two.png").errors == "");
  CHECK(compare(one, read_image(desk.folder / "two.png")).pixels > 20);
}

TEST_CASE("the option --adaptive takes fewer samples for a larger threshold, each corner at least") {
  const SamplingDesk desk;
  const int fine = std::stoi(desk.primary("--adaptive 1")), coarse = std::stoi(desk.primary("--adaptive 32"));
  CHECK(coarse >= 17 * 17);
  CHECK(fine > 2 * coarse);
  CHECK(std::stoi(desk.primary("--adaptive 255")) == 17 * 17);
}

TEST_CASE("a budget says on standard error what became of it, and nothing where that is not wanted") {
  const SamplingDesk desk;
  const Outcome error = desk.trace("-w 32 --error-budget 1 a.ray out.png");
  CHECK(error.status == 0);
  CHECK(error.output == "");
  CHECK_THAT(error.errors,
             Catch::Matches(R"(trace: error [0-9.e-]+ levels as predicted \(1 levels asked for\): )"
                            R"(depth [0-9]+, [0-9]+\.[0-9]{2} samples a pixel; [0-9.]+ s\n)"));
  const Outcome time = desk.trace("-w 32 --time-budget 60 a.ray out.png");
  CHECK(time.status == 0);
  CHECK_THAT(time.errors, Catch::Matches(R"(trace: error [0-9.e-]+ levels as predicted \(60 s asked for\): )"
                                         R"(depth [0-9]+, [0-9]+\.[0-9]{2} samples a pixel; [0-9.]+ s\n)"));
  for (const char* budget : {"--error-budget 1", "--time-budget 60"}) {
    const Outcome quiet = desk.trace("-q -w 32 " + std::string(budget) + " a.ray quiet.png");
    CHECK(quiet.status == 0);
    CHECK(quiet.errors == "");
    CHECK(read_image(desk.folder / "quiet.png").width == 32);
  }
}

TEST_CASE("a time that is too short is told as not met, with a picture and status 0") {
  const SamplingDesk desk;
  const Outcome outcome = desk.trace("-w 400 --aa 1 a.ray out.png");
  REQUIRE(outcome.status == 0);
  const Outcome hasty = desk.trace("-w 400 --time-budget 0.001 a.ray hasty.png");
  CHECK(hasty.status == 0);
  CHECK_THAT(hasty.errors, Catch::Contains("(0.001 s asked for, not met): "));
  CHECK(read_image(desk.folder / "hasty.png").width == 400);
}

TEST_CASE("a depth that is given is kept within a budget") {
  const SamplingDesk desk;
  CHECK_THAT(desk.trace("-w 32 -r 0 --error-budget 1 a.ray out.png").errors,
             Catch::Contains("levels as predicted (1 levels asked for): depth 0, "));
  CHECK_THAT(desk.trace("-w 32 -r 40 --error-budget 1 a.ray out.png").errors,
             Catch::Contains(" as predicted (1 levels asked for): depth 40, "));
}

TEST_CASE("of ways to sample only one can be asked for") {
  const SamplingDesk desk;
  const auto [arguments, message] = GENERATE(table<std::string, std::string>(
      {{"--aa 2 --adaptive 4", "--aa excludes --adaptive"},
       {"--aa 2 --error-budget 1", "--aa excludes --error-budget"},
       {"--time-budget 1 --aa 2", "--aa excludes --time-budget"},
       {"--adaptive 4 --error-budget 1", "--adaptive excludes --error-budget"},
       {"--adaptive 4 --time-budget 1", "--adaptive excludes --time-budget"},
       {"--error-budget 1 --time-budget 1", "--error-budget excludes --time-budget"}}));
  INFO(arguments);
  const Outcome outcome = desk.trace(arguments + " a.ray out.png");
  CHECK(outcome.status == 2);
  CHECK(outcome.errors == "trace: error: " + message + "\nRun 'trace --help' for how to use it.\n");
  CHECK_FALSE(desk.has("out.png"));
}

TEST_CASE("samples, thresholds and budgets have their ranges") {
  const SamplingDesk desk;
  const auto [arguments, message] = GENERATE(table<std::string, std::string>(
      {{"--aa 0", "--aa: Value 0 not in range 1 to 64"},
       {"--aa 65", "--aa: Value 65 not in range 1 to 64"},
       {"--adaptive 0", "--adaptive: '0' is not a number from 0.01 to 255"},
       {"--adaptive 256", "--adaptive: '256' is not a number from 0.01 to 255"},
       {"--error-budget 0.04", "--error-budget: '0.04' is not a number from 0.05 to 255"},
       {"--time-budget 0", "--time-budget: '0' is not a number from 0.001 to 1000000"},
       {"--adaptive nan", "--adaptive: 'nan' is not a number from 0.01 to 255"},
       {"--error-budget nan", "--error-budget: 'nan' is not a number from 0.05 to 255"},
       {"--time-budget nan", "--time-budget: 'nan' is not a number from 0.001 to 1000000"}}));
  INFO(arguments);
  const Outcome outcome = desk.trace(arguments + " a.ray out.png");
  CHECK(outcome.status == 2);
  CHECK(outcome.errors == "trace: error: " + message + "\nRun 'trace --help' for how to use it.\n");
  CHECK_FALSE(desk.has("out.png"));
}

}  // namespace trace::test
