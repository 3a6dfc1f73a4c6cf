// CSV: quoting, and rows that a reader of the format takes apart again.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "report/comparison_csv.hpp"
#include "report/csv.hpp"
#include "report/diff_csv.hpp"
#include "tests/report/sample_report.hpp"
#include "tests/support/run_python.hpp"

namespace trace::test {
namespace {

constexpr const char* to_json = R"(
import csv, io, json, sys
text = sys.stdin.buffer.read().decode("utf-8")
print(json.dumps(list(csv.DictReader(io.StringIO(text, newline=""), strict=True))))
)";

// Rows as Python's reader sees them, each an object of column to field.
nlohmann::json rows(const DiffReport& report) {
  const PythonResult result = run_python(to_json, {}, diff_csv(report));
  INFO(result.output);
  REQUIRE(result.status == 0);
  return nlohmann::json::parse(result.output);
}

}  // namespace

TEST_CASE("CSV fields are quoted where they must be") {
  CHECK(csv_field("plain text") == "plain text");
  CHECK(csv_field("a,b") == "\"a,b\"");
  CHECK(csv_field("say \"hi\"") == "\"say \"\"hi\"\"\"");
  CHECK(csv_field("two\nlines") == "\"two\nlines\"");
  CHECK(csv_field("cr\r") == "\"cr\r\"");
  CHECK(csv_field("") == "");
  CHECK(csv_row({"a", "b,c", ""}) == "a,\"b,c\",\n");
}

TEST_CASE("the CSV of a diff has a row a pair with all figures") {
  DiffReport report = sample_report();
  report.pairs[0].name = "odd, \"name\"\n";
  const nlohmann::json table = rows(report);
  REQUIRE(table.size() == 4);
  const nlohmann::json& row = table[0];
  CHECK(row["name"] == "odd, \"name\"\n");
  CHECK(row["reference"] == "A/beyond.png");
  CHECK(row["verdict"] == "beyond");
  CHECK(row["reason"] == "RMSE 3.25 is over 0.5");
  CHECK(row["diagnosis"] == "shadows are missing");
  CHECK(row["root_mean_square"] == "3.25");
  CHECK(row["largest"] == "16");
  CHECK(row["largest_x"] == "3");
  CHECK(row["largest_reference"] == "255");
  CHECK(row["p99.9"] == "16");
  CHECK(row["ssim"] == "0.75");
  CHECK(row["flip"] == "");
  CHECK(row["foreground_pixels"] == "4");
  CHECK(row["edge_tolerant_percent_over_one"] == "6.25");
  CHECK(row["channel2_mean_signed"] == "-1");
  CHECK(row["channel3_mean_signed"] == "");
  CHECK(row["worst0_x1"] == "4");
  CHECK(row["worst1_x1"] == "");
  CHECK(row["not_finite_test"] == "0");
  CHECK(row["not_finite_first_x"] == "");
}

TEST_CASE("CSV tells equal pictures from pictures without figures") {
  const nlohmann::json table = rows(sample_report());
  CHECK(table[1]["peak_signal_to_noise"] == "inf");
  CHECK(table[1]["root_mean_square"] == "0");
  CHECK(table[3]["verdict"] == "missing");
  CHECK(table[3]["test"] == "");
  CHECK(table[3]["root_mean_square"] == "");
}

TEST_CASE("a CSV row has as many fields as there are columns") {
  const std::size_t columns = comparison_columns().size();
  for (const ComparedPair& pair : sample_report().pairs)
    CHECK(comparison_fields(pair.judgement).size() == columns);
}

}  // namespace trace::test
