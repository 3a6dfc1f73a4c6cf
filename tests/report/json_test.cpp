// JSON of comparisons against docs/schemas, and figure by figure.
#include <catch2/catch.hpp>
#include <limits>

#include "report/comparison_json.hpp"
#include "report/diff_json.hpp"
#include "tests/report/sample_report.hpp"
#include "tests/support/run_python.hpp"

namespace trace::test {

using nlohmann::json;

TEST_CASE("the JSON of a diff fits its published schema") {
  CHECK(schema_faults("diff-1.schema.json", diff_json(sample_report())) == "");
}

TEST_CASE("the schemas refuse a missing member, an unknown one and a wrong type") {
  json document = json::parse(diff_json(sample_report()));
  const auto faults = [&](const char* pointer, const json& value) {
    json changed = document;
    changed[json::json_pointer(pointer)] = value;
    return schema_faults("diff-1.schema.json", changed.dump());
  };
  CHECK(faults("/version", 2) == "version: 1 was expected\n");
  CHECK_THAT(faults("/pairs/0/colour", 1), Catch::Contains("'colour' was unexpected"));
  CHECK_THAT(faults("/pairs/0/measurements/largest/x", "3"), Catch::Contains("measurements"));
  document["pairs"][0].erase("reason");
  CHECK_THAT(schema_faults("diff-1.schema.json", document.dump()),
             Catch::Contains("'reason' is a required property"));
}

TEST_CASE("every figure of a comparison is in its JSON") {
  const DiffReport report = sample_report();
  const json pair = json::parse(comparison_json(report.pairs[0].judgement).dump());
  CHECK(pair["verdict"] == "beyond");
  CHECK(pair["reason"] == "RMSE 3.25 is over 0.5");
  CHECK(pair["diagnosis"] == json({{"kind", "shadows-missing"}, {"text", "shadows are missing"}}));
  CHECK(pair["tolerance"] ==
        json::parse(R"({"rmse":0.5,"max":null,"pixels":0.1,"over":1,"ssim":null,"flip":null})"));
  const json expected = json::parse(R"({
    "width": 4, "height": 2, "channels": 3,
    "mean_absolute": 0.5, "root_mean_square": 3.25, "peak_signal_to_noise": 37.5, "mean_signed": -0.125,
    "largest": {"x": 3, "y": 1, "channel": 2, "reference": 255, "test": 239, "difference": 16},
    "channel": [
      {"mean_absolute": 0.5, "root_mean_square": 3.25, "peak_signal_to_noise": 37.5, "mean_signed": -0.125,
       "largest": 16},
      {"mean_absolute": 0, "root_mean_square": 0, "peak_signal_to_noise": null, "mean_signed": 0,
       "largest": 0},
      {"mean_absolute": 1, "root_mean_square": 2, "peak_signal_to_noise": 42, "mean_signed": -1,
       "largest": 4}],
    "percent_different": 25, "percent_over_one": 12.5, "threshold": 1, "percent_over_threshold": 12.5,
    "percentiles": {"p50": 0, "p90": 4, "p99": 16, "p99.9": 16},
    "ssim": 0.75, "flip": null,
    "foreground": {"pixels": 4, "mean_absolute": 0.5, "root_mean_square": 3.25, "peak_signal_to_noise": 37.5,
                   "mean_signed": -0.125, "largest": 16, "percent_over_one": 25},
    "edge_tolerant": {"root_mean_square": 1.5, "largest": 4, "percent_over_one": 6.25},
    "not_finite": {"reference": 0, "test": 0, "first": null},
    "worst": [{"x0": 2, "y0": 0, "x1": 4, "y1": 2, "pixels": 3, "root_mean_square": 8.5}]})");
  CHECK(pair["measurements"] == expected);
}

TEST_CASE("a diff's JSON counts every verdict and has the status that the worst pair asks for") {
  const json document = json::parse(diff_json(sample_report()));
  CHECK(document["status"] == 3);
  CHECK(document["counts"] == json::parse(R"({"identical":1,"within":0,"beyond":1,"not-finite":0,
    "size-differs":0,"channels-differ":0,"unreadable":0,"missing":1,"extra":1})"));
  CHECK(document["pairs"][2]["reference"].is_null());
  CHECK(document["pairs"][2]["test"] == "B/simple/extra.png");
  CHECK(document["pairs"][3]["test"].is_null());
  CHECK(document["pairs"][3]["measurements"].is_null());
}

TEST_CASE("what is not finite is never written to JSON as a number") {
  Judgement judgement = judged(Verdict::not_finite);
  judgement.measurements = sample_measurements();
  judgement.measurements->ssim = std::numeric_limits<double>::quiet_NaN();
  judgement.measurements->not_finite = {0, 2, {1, 1}};
  const DiffReport report{"A", "B", {{"nan", "A/nan.exr", "B/nan.exr", judgement}}};
  const std::string text = diff_json(report);
  CHECK(schema_faults("diff-1.schema.json", text) == "");
  const json measured = json::parse(text)["pairs"][0]["measurements"];
  CHECK(measured["ssim"].is_null());
  CHECK(measured["not_finite"] == json::parse(R"({"reference":0,"test":2,"first":{"x":1,"y":1}})"));
}

TEST_CASE("a file name that is not UTF-8 does not spoil the JSON") {
  DiffReport report = sample_report();
  report.pairs[0].name = "b\xFFx\"\n";
  CHECK(json::parse(diff_json(report))["pairs"][0]["name"] == "b\xEF\xBF\xBDx\"\n");
}

}  // namespace trace::test
