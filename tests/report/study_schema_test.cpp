// The JSON of a study against docs/schemas.
#include <catch2/catch.hpp>

#include "tests/report/sample_study.hpp"
#include "tests/support/run_python.hpp"
#include "tests/support/temporary_folder.hpp"

namespace trace::test {

TEST_CASE("studies fit their published schema") {
  const TemporaryFolder folder;
  const SampleStudy study = sample_study(folder.path());
  CHECK(schema_faults("study-1.schema.json", study.report.dump()) == "");
  CHECK(schema_faults("study-1.schema.json", made_up_study(3, 20).dump()) == "");
}

TEST_CASE("the schema of a study refuses a missing member, an unknown one and a wrong type") {
  const nlohmann::ordered_json report = made_up_study(1, 3);
  const auto faults = [&](const char* pointer, const nlohmann::ordered_json& value) {
    nlohmann::ordered_json changed = report;
    changed[nlohmann::ordered_json::json_pointer(pointer)] = value;
    return schema_faults("study-1.schema.json", changed.dump());
  };
  CHECK(faults("/version", 2) == "version: 1 was expected\n");
  CHECK_THAT(faults("/scenes/0/results/0/colour", 1), Catch::Contains("'colour' was unexpected"));
  CHECK_THAT(faults("/scenes/0/results/0/ms/median", "3"), Catch::Contains("median"));
  CHECK_THAT(faults("/scenes/0/results/0/error/against", "solution"), Catch::Contains("against"));
  nlohmann::ordered_json less = report;
  less["scenes"][0]["results"][0].erase("memory");
  CHECK_THAT(schema_faults("study-1.schema.json", less.dump()),
             Catch::Contains("'memory' is a required property"));
}

}  // namespace trace::test
