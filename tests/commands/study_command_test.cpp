// `trace study`: what is printed and written, which scenes are studied, and what it says where it cannot.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "loading/scene_loader.hpp"
#include "study/setting.hpp"
#include "tests/support/batch_folder.hpp"
#include "tests/support/run_python.hpp"
#include "tests/support/scene_picture.hpp"

namespace trace::test {
namespace {

// As tests of a batch have it; each study is as short as it can be.
struct StudyDesk : BatchFolder {
  Outcome study(const std::string& arguments) const {
    return run_trace(path(), "study --seconds 0 " + arguments);
  }
  nlohmann::json json(const std::string& file) const {
    return nlohmann::json::parse(read_text(*this / file));
  }
};

const std::string tiny = "-w 16 --axes samples ";

}  // namespace

TEST_CASE("a study prints a table of its settings and what is fastest for an error") {
  const StudyDesk desk;
  desk.add_scene("a.ray", sphere);
  const Outcome outcome = desk.study("-w 16 --axes samples,adaptive scenes/a.ray");
  CHECK(outcome.status == 0);
  CHECK(outcome.errors == "[1/1] scenes/a.ray\n");
  CHECK_THAT(outcome.output,
             Catch::StartsWith(
                 "scenes/a.ray, 16 x 16, depth 0; truth: 1024 samples a pixel, depth 0, itself off by "));
  for (const char* setting : {"1 ", "2x2", "8x8", "adaptive 64", "adaptive 1 "}) {
    CHECK_THAT(outcome.output, Catch::Contains("\n* " + std::string(setting)) ||
                                   Catch::Contains("\n  " + std::string(setting)));
  }
  CHECK_THAT(outcome.output, !Catch::Contains("depth 1") && !Catch::Contains("budget"));
  CHECK_THAT(outcome.output, Catch::Contains("\nfor an error below 4 the fastest is "));
  CHECK(desk.study("-q " + tiny + "scenes/a.ray").errors == "");
}

TEST_CASE("a study writes its results as JSON, a table, a plot and a page") {
  const StudyDesk desk;
  desk.add_scene("a.ray", sphere);
  desk.add_scene("b.ray", box);
  const Outcome outcome =
      desk.study("-w 16 --axes adaptive,needs --json r.json --csv r.csv --svg r.svg --report r.html scenes");
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.output,
             Catch::Contains("\n2 scenes, relative to one sample a pixel (geometric means)\n"));
  CHECK_THAT(outcome.output, Catch::EndsWith("\nr.html\n"));
  CHECK(schema_faults("study-1.schema.json", read_text(desk / "r.json")) == "");
  const auto json = desk.json("r.json");
  CHECK(json.at("title") == "scenes");
  CHECK(json.at("command") ==
        "trace study --seconds 0 -w 16 --axes adaptive,needs --json r.json --csv r.csv --svg "
        "r.svg --report r.html scenes");
  REQUIRE(json.at("scenes").size() == 2);
  CHECK(json.at("scenes").at(0).at("scene") == "a.ray");
  for (const auto& result : json.at("scenes").at(0).at("results")) {
    CHECK(result.at("ms").at("median") > 0);
    CHECK(result.at("rays").at("primary") >= 256);
    if (result.at("setting") == "everything") CHECK(result.at("same_picture") == true);
  }
  const std::size_t rows = 2 * json.at("settings").size() + 1;
  CHECK(desk.lines("r.csv") == rows);
  CHECK_THAT(read_text(desk / "r.svg"), Catch::StartsWith("<svg ") || Catch::StartsWith("<?xml "));
  CHECK_THAT(read_text(desk / "r.html"),
             Catch::Contains("</html>") && Catch::Contains("<script type=\"image/png\""));
}

TEST_CASE("the errors of a study are less with more samples, and those of the first are the picture's own") {
  const StudyDesk desk;
  desk.add_scene("a.ray", sphere);
  REQUIRE(desk.study(tiny + "--json r.json -q scenes/a.ray").status == 0);
  const auto json = desk.json("r.json");
  const auto& results = json.at("scenes").at(0).at("results");
  double before = 255;
  for (const auto& result : results) {
    CHECK(result.at("error").at("rms") < before);
    before = result.at("error").at("rms");
  }
  CHECK(before < 0.1);
  CHECK(results.at(0).at("error").at("rms") > 0.1);
}

TEST_CASE("results on standard output are alone there, and only one kind of them can be") {
  const StudyDesk desk;
  desk.add_scene("a.ray", sphere);
  const Outcome json = desk.study(tiny + "--json - scenes/a.ray");
  CHECK(json.status == 0);
  CHECK(nlohmann::json::parse(json.output).at("format") == "trace-study");
  CHECK_THAT(desk.study(tiny + "--csv - scenes/a.ray").output, Catch::StartsWith("scene,"));
  const Outcome two = desk.study(tiny + "--csv - --json - scenes/a.ray");
  CHECK(two.status == 2);
  CHECK(two.errors ==
        "trace: error: only one of --json, --csv and --svg can go to standard output\n"
        "Run 'trace study --help' for how to use it.\n");
}

TEST_CASE("a scene that is not there is told of and is status 1") {
  const StudyDesk desk;
  const Outcome outcome = desk.study(tiny + "none.ray");
  CHECK(outcome.status == 1);
  CHECK(outcome.output == "");
  CHECK(outcome.errors == "[1/1] none.ray\ntrace: error: cannot read 'none.ray': no such file\n");
}

TEST_CASE("a broken scene among good ones is told of, the others are studied, and the status is 1") {
  const StudyDesk desk;
  desk.add_scene("a.ray", sphere);
  desk.add_scene("b.ray", "shpere {}");
  desk.add_scene("c.ray", box);
  const Outcome outcome = desk.study(tiny + "-q --json r.json scenes");
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.errors, Catch::StartsWith("scenes/b.ray:3:1: error: unknown word 'shpere'"));
  const auto json = desk.json("r.json");
  REQUIRE(json.at("scenes").size() == 2);
  CHECK(json.at("scenes").at(1).at("scene") == "c.ray");
}

TEST_CASE("where no scene can be studied nothing is written") {
  const StudyDesk desk;
  desk.add_scene("b.ray", "shpere {}");
  const Outcome outcome = desk.study(tiny + "--json r.json scenes");
  CHECK(outcome.status == 1);
  CHECK_FALSE(std::filesystem::exists(desk / "r.json"));
  std::filesystem::create_directories(desk / "empty");
  const Outcome none = desk.study(tiny + "empty");
  CHECK(none.status == 1);
  CHECK(none.errors == "trace: error: no scenes to study\n");
}

TEST_CASE("a study that cannot be understood is status 2 and says why") {
  const StudyDesk desk;
  desk.add_scene("a.ray", sphere);
  const auto [arguments, message] = GENERATE(table<std::string, std::string>(
      {{"", "scenes is required"},
       {"-w 0 scenes/a.ray", "--width: Value 0 not in range 1 to 65536"},
       {"-r -1 scenes/a.ray", "--depth: Value -1 not in range 0 to 1000"},
       {"--seconds -1 scenes/a.ray", "--seconds: '-1' is not a number from 0 to 1000000"},
       {"--axes colour scenes/a.ray",
        "--axes: colour not in "
        "{samples,adaptive,budget,course,depth,contribution,resolution,arithmetic,needs,patterns}"},
       {"--report - scenes/a.ray", "--report needs a file, not standard output"},
       {"--fast scenes/a.ray", "The following argument was not expected: --fast"}}));
  INFO(arguments);
  const Outcome outcome = run_trace(desk.path(), "study " + arguments);
  CHECK(outcome.status == 2);
  CHECK(outcome.errors == "trace: error: " + message + "\nRun 'trace study --help' for how to use it.\n");
  CHECK(outcome.output == "");
}

TEST_CASE("results that cannot be written are status 3, found before anything is studied") {
  const StudyDesk desk;
  for (const std::string option : {"--json", "--csv", "--svg", "--report"}) {
    const Outcome outcome = desk.study(tiny + option + " no/r.out none.ray");
    INFO(option);
    CHECK(outcome.status == 3);
    CHECK_THAT(outcome.errors, Catch::StartsWith("trace: error: cannot write 'no/r.out': "));
    CHECK_THAT(outcome.errors, !Catch::Contains("none.ray"));
  }
}

TEST_CASE(
    "of batch.json a study takes what scenes are drawn with, but not how large and deep, nor how sampled") {
  const StudyDesk desk;
  desk.add_scene("a.ray", sphere);
  desk.add_scene("draft.ray", box);
  write_text(desk / "scenes/batch.json",
             R"({"default": {"width": 99, "depth": 0, "settings": {"shadows": false, "anti_alias": true}},)"
             R"( "exclude": ["draft*"]})");
  desk.add_scene(
      "shadowed.ray",
      sphere + "\ntranslate(0, -1.5, 0, scale(9, 0.2, 9, box { material = { diffuse = (1,1,1); } }))");
  REQUIRE(desk.study(tiny + "-q --json r.json scenes").status == 0);
  const auto json = desk.json("r.json");
  REQUIRE(json.at("scenes").size() == 2);
  const auto& scene = json.at("scenes").at(1);
  CHECK(scene.at("scene") == "shadowed.ray");
  CHECK(scene.at("width") == 16);
  const auto& one = scene.at("results").at(0);
  CHECK(one.at("rays").at("primary") == 256);
  CHECK(one.at("rays").at("shadow") == 0);
}

TEST_CASE("a batch.json that is wrong is told of before anything is studied") {
  const StudyDesk desk;
  desk.add_scene("a.ray", sphere);
  write_text(desk / "scenes/batch.json", R"({"default": {"width": 0}})");
  const Outcome outcome = desk.study(tiny + "scenes");
  CHECK(outcome.status == 1);
  CHECK(outcome.output == "");
  CHECK_THAT(outcome.errors,
             Catch::StartsWith("scenes/batch.json:1:23: error: 'width' takes a whole number"));
}

TEST_CASE("a study compares with solutions of its pictures' size, which is theirs where none is asked for") {
  const StudyDesk desk;
  desk.add_scene("a.ray", sphere);
  std::filesystem::create_directories(desk / "sol");
  REQUIRE(run_trace(desk.path(), "-w 20 scenes/a.ray sol/a.png").status == 0);
  const auto studied = [&](const std::string& options) {
    REQUIRE(desk.study("--axes samples -q --json r.json --solutions sol " + options + " scenes").status == 0);
    return desk.json("r.json").at("scenes").at(0);
  };
  const auto same = studied("");
  CHECK(same.at("width") == 20);
  CHECK(same.at("solution") == "sol/a.png");
  CHECK(same.at("results").at(0).at("solution").at("rms") == 0);
  CHECK(same.at("results").at(1).at("solution").at("rms") > 0.1);
  const auto other = studied("-w 16");
  CHECK(other.at("width") == 16);
  CHECK_FALSE(other.contains("solution"));
  CHECK_FALSE(other.at("results").at(0).contains("solution"));
  CHECK_THAT(desk.study("--axes samples --solutions sol -w 8 scenes").errors,
             Catch::Contains("trace: warning: 'sol/a.png' is "));
  const Outcome none = desk.study("--solutions none scenes");
  CHECK(none.status == 1);
  CHECK(none.errors == "trace: error: 'none' is not a folder\n");
}

TEST_CASE("a picture too wide to be made smaller is studied without that") {
  const StudyDesk desk;
  desk.add_scene("wide.ray", "camera { aspectratio = 200 }\n" + std::string(sphere));
  REQUIRE(desk.study("-w 256 --axes samples,resolution -q --json r.json scenes").status == 0);
  const auto results = desk.json("r.json").at("scenes").at(0).at("results");
  const auto has = [&](const std::string& name) {
    return std::any_of(results.begin(), results.end(),
                       [&](const auto& r) { return r.at("setting") == name; });
  };
  CHECK(has("2x2"));
  CHECK(has("1/2 width"));
  CHECK_FALSE(has("1/4 width"));
}

TEST_CASE("a depth that is asked for is the truth's too") {
  const StudyDesk desk;
  desk.add_scene("a.ray",
                 "sphere { material = { reflective = (0.5, 0.5, 0.5); emissive = (0.2, 0.2, 0.2); } }\n"
                 "translate(0, 0, -6, scale(20, 20, 1, box { material = { emissive = (0.2, 0.4, 0.2); "
                 "reflective = (0.5, 0.5, 0.5); } }))");
  const auto studied = [&](const std::string& options) {
    REQUIRE(desk.study("-w 16 --axes depth -q --json r.json " + options + " scenes/a.ray").status == 0);
    return desk.json("r.json").at("scenes").at(0);
  };
  CHECK(studied("-r 1").at("converged").at("depth") == 1);
  CHECK(studied("-r 1").at("depth") == 1);
  CHECK(studied("").at("converged").at("depth") > 1);
  CHECK(studied("").at("depth") <= studied("").at("converged").at("depth"));
}

TEST_CASE("the options that a study names for a setting draw that setting's picture") {
  const StudyDesk desk;
  desk.add_scene(
      "a.ray",
      "sphere { material = { diffuse = (0.8, 0.5, 0.2); reflective = (0.4, 0.4, 0.4); } }\n"
      "translate(0, -2, 0, box { material = { diffuse = (0.2, 0.5, 0.2); reflective = (0.4, 0.4, 0.4); } })");
  FileImages images;
  const LoadedScene loaded = load_scene((desk / "scenes/a.ray").string(), 16, images);
  REQUIRE(loaded.scene);
  LadderScene ladder;
  ladder.options.width = 16;
  ladder.options.depth = 5;
  ladder.depths = {0, 1, 2, 3};
  std::vector<Axis> axes{Axis::adaptive, Axis::depth, Axis::contribution, Axis::needs};
  int compared = 0;
  for (const Setting& setting : ladders(ladder, axes)) {
    if (setting.flags.empty()) continue;
    ++compared;
    INFO(setting.flags);
    REQUIRE(run_trace(desk.path(), "-w 16 " + setting.flags + " scenes/a.ray out.png").status == 0);
    CHECK(read_image(desk / "out.png").rgb == rendered(*loaded.scene, setting.options).image.rgb);
  }
  CHECK(compared > 15);
}

}  // namespace trace::test
