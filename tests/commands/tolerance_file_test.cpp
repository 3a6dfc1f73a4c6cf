// Tolerances scene by scene: which entry counts, what is an error, what --update writes.
#include "loading/tolerance_file.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tools/trace/diff/tolerance_update.hpp"

namespace trace::test {
namespace {

struct Read {
  parser::Source source;
  parser::Diagnostics diagnostics;
  std::optional<ToleranceFile> file;

  explicit Read(const std::string& text)
      : source(parser::Source::from_text("t.json", text)), file(read_tolerances(source, diagnostics)) {}
  std::string messages() const { return parser::render(source, diagnostics); }
  double rmse(std::string_view scene) const { return file->tolerance(scene).rmse.value_or(-1); }
};

std::string errors(const std::string& text) {
  const Read read(text);
  CHECK(!read.file);
  return read.messages();
}

}  // namespace

TEST_CASE("of several entries that fit a scene the one with most literal characters counts") {
  const Read read(R"({ "default": {"rmse": 1}, "*": {"rmse": 2}, "simple/*": {"rmse": 3},
                       "simple/box": {"rmse": 4}, "simple/b[aeo]?": {"rmse": 5}, "*e/box2": {"rmse": 6} })");
  REQUIRE(read.file);
  CHECK(read.rmse("polymesh/dragon") == 2);
  CHECK(read.rmse("simple/cone") == 3);
  CHECK(read.rmse("simple/box") == 4);
  CHECK(read.rmse("simple/bex") == 5);
  CHECK(read.rmse("simple/box2") == 3);
  CHECK(read.rmse("a/simple/box2") == 6);
}

TEST_CASE("of equally specific entries the last counts") {
  const Read read(R"({ "a*": {"rmse": 1}, "*a": {"rmse": 2} })");
  CHECK(read.rmse("aa") == 2);
}

TEST_CASE("where no entry fits, the file's default counts, or else the program's") {
  const Read with(R"({ "default": {"max": 3}, "x": {"rmse": 9} })");
  CHECK(with.file->tolerance("y").max == 3.0);
  CHECK(!with.file->tolerance("y").rmse);
  const Read without(R"({ "x": {"rmse": 9} })");
  CHECK(without.file->tolerance("y").rmse == 0.5);
  CHECK(without.file->tolerance("y").pixels == 0.1);
  CHECK(Read("{}").file->tolerance("y").rmse == 0.5);
}

TEST_CASE("an entry stands for itself: what it does not give is not looked at") {
  const Read read(R"({ "x": {"pixels": 2, "over": 8, "ssim": 0.9, "flip": 0.1, "reason": "noise"} })");
  const Tolerance t = read.file->tolerance("x");
  CHECK(!t.rmse);
  CHECK(!t.max);
  CHECK(t.pixels == 2.0);
  CHECK(t.over == 8.0);
  CHECK(t.ssim == 0.9);
  CHECK(t.flip == 0.1);
  CHECK(read.file->find("x")->reason == "noise");
  const Tolerance any = Read(R"({ "x": {"rmse": null} })").file->tolerance("x");
  CHECK(!any.rmse);
  CHECK(!any.pixels);
}

TEST_CASE("a scene whose name has the shell's characters has a pattern of its own") {
  for (const std::string scene : {"a*b", "x[1]", "q?", "back\\slash", "default", "plain"}) {
    const nlohmann::json text = {{literal_pattern(scene), {{"rmse", 7}}}};
    const Read read(text.dump());
    REQUIRE(read.file);
    CHECK(read.rmse(scene) == 7);
    CHECK(read.rmse("aXb") == 0.5);
    CHECK(read.rmse("x1") == 0.5);
  }
}

TEST_CASE("what is wrong in a tolerance file is an error at its own place") {
  CHECK(errors("{ \"simple/box\": {\"rms\": 2} }") ==
        "t.json:1:18: error: unknown tolerance 'rms'\n"
        "{ \"simple/box\": {\"rms\": 2} }\n"
        "                 ^~~~~\n"
        "t.json:1:18: note: did you mean 'rmse'?\n");
  CHECK_THAT(errors("{ \"x\": {\"rmse\": \"2\"} }"),
             Catch::StartsWith("t.json:1:17: error: 'rmse' takes a number that is not negative or null\n"));
  CHECK_THAT(errors("{ \"x\": {\"pixels\": 101} }"),
             Catch::StartsWith("t.json:1:19: error: 'pixels' takes a number from 0 to 100 or null\n"));
  CHECK_THAT(errors("{ \"x\": 2 }"),
             Catch::StartsWith("t.json:1:8: error: 'x' takes an object, such as { \"rmse\": 2 }\n"));
  CHECK_THAT(
      errors("{ \"x\": {\"over\": 2} }"),
      Catch::StartsWith("t.json:1:9: error: 'over' needs 'pixels': the share of pixels that may be off by "
                        "more\n"));
  CHECK_THAT(errors("{ \"x\": {\"reason\": \"r\"} }"),
             Catch::StartsWith("t.json:1:3: error: 'x' gives no tolerance\n"));
  CHECK_THAT(errors("{\n \"x\": {\"rmse\": 1},\n \"x\": {\"rmse\": 2} }"),
             Catch::StartsWith("t.json:3:2: error: 'x' is given twice\n"));
  CHECK_THAT(errors("{ \"x\": {\"rmse\": 1, \"rmse\": 2} }"),
             Catch::StartsWith("t.json:1:20: error: 'rmse' is given twice\n"));
  CHECK_THAT(errors("[]"), Catch::StartsWith("t.json:1:1: error: a tolerance file holds one object"));
  CHECK_THAT(errors("{"), Catch::StartsWith("t.json:1:2: error: the JSON text ends too early\n"));
}

TEST_CASE("an entry that fits no picture is warned of, with the name that may be meant") {
  Read read(R"({ "simpel/box": {"rmse": 1}, "simple/*": {"rmse": 2} })");
  warn_of_unused(*read.file, {"simple/box", "simple/cone"}, read.diagnostics);
  CHECK(read.messages() ==
        "t.json:1:3: warning: no picture is named 'simpel/box'\n"
        "{ \"simpel/box\": {\"rmse\": 1}, \"simple/*\": {\"rmse\": 2} }\n"
        "  ^~~~~~~~~~~~\n"
        "t.json:1:3: note: did you mean 'simple/box'?\n");
}

TEST_CASE("an accepted difference lies within the new limits, which are round numbers") {
  Measurements m;
  m.error.root_mean_square = 3.2041;
  m.error.largest = 250;
  m.percent_over_threshold = 14.21;
  m.ssim = 0.91237;
  m.flip = 0.0123;
  const Tolerance t = accepting({0.5, 255, 0.1, 1, 0.99, 0.001}, m);
  CHECK(t.rmse == 3.3);
  CHECK(t.max == 255.0);
  CHECK(t.pixels == 15.0);
  CHECK(t.over == 1.0);
  CHECK(t.ssim == 0.9123);
  CHECK(t.flip == 0.013);
  CHECK(!accepting({0.5, {}, {}, 1, {}, {}}, m).max);
  for (double value = 0.0007; value < 300; value *= 1.01) {
    m.error.root_mean_square = value;
    const double limit = *accepting({0.0, {}, {}, 1, {}, {}}, m).rmse;
    CHECK(limit >= value);
    CHECK(limit <= value * 1.1001);
  }
}

TEST_CASE("updating keeps other entries and their order, and says why") {
  const std::string text = with_accepted(
      R"({"simple/*": {"rmse": 2, "reason": "old"}, "default": {"rmse": 0.5}, "box": {"max": 1}})",
      {{"box", {3.3, {}, 15, 2, {}, {}}}, {"new", {{}, 4, {}, 1, 0.9, {}}}}, "the \"new\" noise");
  CHECK(text ==
        "{\n"
        "  \"simple/*\": {\"rmse\":2,\"reason\":\"old\"},\n"
        "  \"default\": {\"rmse\":0.5},\n"
        "  \"box\": {\"rmse\":3.3,\"pixels\":15.0,\"over\":2.0,\"reason\":\"the \\\"new\\\" noise\"},\n"
        "  \"new\": {\"max\":4.0,\"ssim\":0.9,\"reason\":\"the \\\"new\\\" noise\"}\n"
        "}\n");
  CHECK(Read(text).file);
  CHECK(with_accepted("", {}, "r") == "{\n}\n");
}

}  // namespace trace::test
