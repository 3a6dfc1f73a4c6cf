// The picture of a study: well-formed, with each setting where its figures say.
#include "report/study_svg.hpp"

#include <catch2/catch.hpp>

#include "report/log_scale.hpp"
#include "tests/report/sample_study.hpp"
#include "tests/support/run_python.hpp"

namespace trace::test {
namespace {

// Places of the marks by their titles, the texts, the places along the front, the size.
constexpr const char* read_svg = R"python(
import json, re, sys
import xml.etree.ElementTree as tree
space = "{http://www.w3.org/2000/svg}"
root = tree.fromstring(sys.stdin.buffer.read())
marks = {}
for path in root.iter(space + "path"):
    title = path.find(space + "title")
    if title is not None:
        x, y = re.match(r"translate\((\S+) (\S+)\)", path.get("transform")).groups()
        marks[title.text] = {"x": float(x), "y": float(y), "class": path.get("class")}
front = [[float(part) for part in place.split(",")] for place in root.find(space + "polyline").get("points").split()]
print(json.dumps({"marks": marks, "texts": [text.text for text in root.iter(space + "text")], "front": front,
                  "arrows": sum(1 for path in root.iter(space + "path") if path.get("class") == "front"),
                  "elements": sorted({element.tag.replace(space, "") for element in root.iter()}),
                  "size": [float(root.get("width")), float(root.get("height"))]}))
)python";

nlohmann::json parsed_svg(const nlohmann::ordered_json& report) {
  const PythonResult result = run_python(read_svg, {}, study_svg(report));
  INFO(result.output);
  REQUIRE(result.status == 0);
  return nlohmann::json::parse(result.output);
}

nlohmann::ordered_json three_settings() {
  nlohmann::ordered_json report = made_up_study(1, 3);
  nlohmann::ordered_json& results = report["all"]["results"];
  results[0].update({{"time", 1}, {"error", 1}, {"front", true}});
  results[1].update({{"time", 10}, {"error", 0.1}, {"front", true}});
  results[2].update({{"time", 100}, {"error", 0.1}, {"front", false}});
  return report;
}

}  // namespace

TEST_CASE("the picture of a study has each setting at its place on logarithmic axes") {
  const nlohmann::json svg = parsed_svg(three_settings());
  REQUIRE(svg["marks"].size() == 3);
  const auto at = [&](const char* title, const char* key) {
    return svg["marks"].at(title).at(key).get<double>();
  };
  const char* one = "1: 1 x the time, 1 x the error";
  const char* two = "2x2: 10 x the time, 0.1 x the error";
  const char* three = "3x3: 100 x the time, 0.1 x the error";
  CHECK(at(two, "x") - at(one, "x") == Approx(at(three, "x") - at(two, "x")).margin(0.11));
  CHECK(at(one, "x") < at(two, "x"));
  CHECK(at(one, "y") < at(two, "y"));  // less error is further down
  CHECK(at(two, "y") == at(three, "y"));
}

TEST_CASE("the front in the picture of a study is a line through its points, which are filled and named") {
  const nlohmann::json svg = parsed_svg(three_settings());
  const nlohmann::json& one = svg["marks"]["1: 1 x the time, 1 x the error"];
  const nlohmann::json& two = svg["marks"]["2x2: 10 x the time, 0.1 x the error"];
  CHECK(svg["front"] == nlohmann::json::array({{one["x"], one["y"]}, {two["x"], two["y"]}}));
  CHECK(one["class"] == "mark a0");
  CHECK(svg["marks"]["3x3: 100 x the time, 0.1 x the error"]["class"] == "mark a0 open");
  const auto named = [&](const char* text) {
    return std::find(svg["texts"].begin(), svg["texts"].end(), text) != svg["texts"].end();
  };
  CHECK(named("1"));
  CHECK(named("2x2"));
  CHECK_FALSE(named("3x3"));
  CHECK(named("Samples a pixel"));
  CHECK_FALSE(named("Depth"));  // an axis without points
}

TEST_CASE("in the picture of a study a setting without error is below all others and marked") {
  nlohmann::ordered_json report = three_settings();
  CHECK(parsed_svg(report)["arrows"] == 0);
  report["all"]["results"][1]["error"] = 0;
  const nlohmann::json svg = parsed_svg(report);
  const nlohmann::json& marks = svg["marks"];
  const double none = marks.at("2x2: 10 x the time, no error")["y"];
  CHECK(none > marks.at("3x3: 100 x the time, 0.1 x the error")["y"].get<double>());
  CHECK(none < svg["size"][1].get<double>());
  CHECK(svg["arrows"] == 1);
}

TEST_CASE("no name can add markup to the picture of a study") {
  nlohmann::ordered_json report = three_settings();
  const std::string nasty = "</text><script>alert(1)</script>&\"'\x01\xFF";
  report["title"] = nasty;
  report["machine"]["processor"] = nasty;
  report["settings"][0]["name"] = report["all"]["results"][0]["setting"] = nasty;
  report["axes"][0]["title"] = nasty;
  const std::vector<std::string> elements{"line",  "path", "polyline", "rect",
                                          "style", "svg",  "text",     "title"};
  CHECK(parsed_svg(report)["elements"] == elements);
}

TEST_CASE("a study without results has a picture without points") {
  nlohmann::ordered_json report = made_up_study(0, 0);
  CHECK(parsed_svg(report)["marks"].empty());
}

TEST_CASE("the ticks of a logarithmic scale are round numbers within it") {
  CHECK(LogScale({1, 10}, 0, 100).ticks() == std::vector<double>{1, 2, 5, 10});
  CHECK(LogScale({0.01, 100}, 0, 100).ticks() == std::vector<double>{0.01, 0.1, 1, 10, 100});
  const LogScale scale({1, 100}, 20, 120);
  CHECK(scale(10) == Approx(70));
  CHECK(scale(1) > 20);
  CHECK(scale(100) < 120);
}

}  // namespace trace::test
