// The CSV of a study, as a reader of the format takes it apart.
#include "report/study_csv.hpp"

#include <catch2/catch.hpp>

#include "tests/report/sample_study.hpp"
#include "tests/support/run_python.hpp"

namespace trace::test {
namespace {

constexpr const char* study_rows = R"(
import csv, io, json, sys
text = sys.stdin.buffer.read().decode("utf-8")
rows = list(csv.DictReader(io.StringIO(text, newline=""), strict=True))
assert all(None not in row and None not in row.values() for row in rows)
print(json.dumps(rows))
)";

nlohmann::json read_rows(const nlohmann::ordered_json& report) {
  const PythonResult result = run_python(study_rows, {}, study_csv(report));
  INFO(result.output);
  REQUIRE(result.status == 0);
  return nlohmann::json::parse(result.output);
}

}  // namespace

TEST_CASE("the CSV of a study has a row a scene and setting with all figures") {
  nlohmann::ordered_json report = made_up_study(2, 3);
  report["scenes"][0]["scene"] = "odd, \"name\"\n.ray";
  report["scenes"][0]["chosen"] = "2x2";
  nlohmann::ordered_json& result = report["scenes"][0]["results"][1];
  result["ms"] = {{"median", 3.1}, {"low", 3.0}, {"high", 3.25}, {"runs", 9}};
  result["error"] = {
      {"rms", 1.93}, {"uncertainty", 0.02}, {"mean", 0.4}, {"largest", 88.1}, {"against", "converged"}};
  result["solution"] = {{"rms", 0.31}, {"off_by_more_than_one", 2.4}};
  result["rays"] = {{"primary", 1}, {"reflected", 2}, {"refracted", 3}, {"shadow", 4}};
  result["gain"] = {{"over", "1"}, {"ms", 2.1}, {"rms", -2.2}};
  result["front"] = true;
  const nlohmann::json rows = read_rows(report);
  REQUIRE(rows.size() == 6);
  const nlohmann::json expected = {{"scene", "odd, \"name\"\n.ray"},
                                   {"width", "64"},
                                   {"height", "48"},
                                   {"depth", "5"},
                                   {"converged_samples", "256"},
                                   {"converged_error", "0.02"},
                                   {"setting", "2x2"},
                                   {"axis", "samples"},
                                   {"options", "--aa 2"},
                                   {"ms", "3.1"},
                                   {"ms_low", "3"},
                                   {"ms_high", "3.25"},
                                   {"runs", "9"},
                                   {"rms", "1.93"},
                                   {"rms_uncertainty", "0.02"},
                                   {"mean_error", "0.4"},
                                   {"largest_error", "88.1"},
                                   {"against", "converged"},
                                   {"solution_rms", "0.31"},
                                   {"solution_percent_over_one", "2.4"},
                                   {"primary_rays", "1"},
                                   {"reflected_rays", "2"},
                                   {"refracted_rays", "3"},
                                   {"shadow_rays", "4"},
                                   {"memory", "12345678"},
                                   {"front", "true"},
                                   {"gain_over", "1"},
                                   {"gain_ms", "2.1"},
                                   {"gain_rms", "-2.2"},
                                   {"same_picture", ""},
                                   {"chosen", "true"}};
  CHECK(rows[1] == expected);
  CHECK(rows[0]["chosen"] == "false");
  CHECK(rows[5]["scene"] == "folder/scene1.ray");
}

TEST_CASE("what a study does not know is an empty field of its CSV") {
  const nlohmann::json rows = read_rows(made_up_study(1, 2));
  for (const char* name :
       {"solution_rms", "solution_percent_over_one", "gain_over", "gain_ms", "same_picture"})
    CHECK(rows[0][name] == "");
  CHECK(rows[1]["gain_over"] == "1");
  CHECK(study_csv(made_up_study(0, 2)).find("\n") == study_csv(made_up_study(0, 2)).size() - 1);
}

TEST_CASE("a scene's name that is not UTF-8 does not spoil the CSV of a study") {
  nlohmann::ordered_json report = made_up_study(1, 1);
  report["scenes"][0]["scene"] = "caf\xE9.ray";
  CHECK(read_rows(report)[0]["scene"] == "caf\uFFFD.ray");
}

}  // namespace trace::test
