// results.json of `trace batch` against docs/schemas.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/support/batch_folder.hpp"
#include "tests/support/run_python.hpp"

namespace trace::test {
namespace {

using nlohmann::json;

// Scenes that end in different ways: compared and found alike and unlike, not compared, wrong.
struct MixedBatch : BatchFolder {
  MixedBatch() {
    for (const char* name : {"alike.ray", "deep/unlike.ray", "wrong.ray"}) add_scene(name, sphere);
    REQUIRE(run("scenes -o sol -w 40").status == 0);
    add_scene("deep/unlike.ray", box);
    add_scene("new.ray", box);
    add_scene("wrong.ray", "shpere {}");
  }
};

std::string faults(const json& document) {
  return schema_faults("batch-1.schema.json", document.dump());
}

}  // namespace

TEST_CASE("the results of a batch fit their published schema, however its scenes end") {
  const MixedBatch batch;
  REQUIRE(batch.run("scenes -o out -w 40 --solutions sol").status == 3);
  const json results = batch.results("out");
  CHECK(faults(results) == "");
  CHECK(batch.verdict("alike.ray") == "identical");
  CHECK(batch.verdict("deep/unlike.ray") == "beyond");
  CHECK(batch.outcome("wrong.ray") == "failed");
  CHECK(results.at("counts") == json::parse(R"({"scenes":4,"rendered":3,"failed":1,"identical":1,"within":0,
    "beyond":1,"not-finite":0,"size-differs":0,"channels-differ":0,"unreadable":0,"missing":0,"extra":0,
    "not_compared":1})"));
  batch.run("scenes -o out -w 40 --solutions sol");  // most of it done before
  CHECK(faults(batch.results("out")) == "");
}

TEST_CASE("the results of other programs fit the schema of a batch") {
  const MixedBatch batch;
  const std::string own = std::string("'own=") + TRACE_PROGRAM + " -q -w {width} {scene} {out}'";
  REQUIRE(batch
              .run("scenes -o out -w 40 --solutions sol --exec " + own +
                   " --exec 'dies=sh -c \"kill -SEGV \\$\\$\" {scene} {out}'"
                   " --exec 'fails=false {scene} {out}' --exec 'idle=true {scene} {out}'"
                   " --include 'alike*'")
              .status == 3);
  const json results = batch.results("out");
  CHECK(faults(results) == "");
  std::vector<std::string> outcomes;
  for (const json& result : results.at("results")) outcomes.push_back(result.at("outcome"));
  CHECK(outcomes == std::vector<std::string>{"rendered", "crashed", "failed", "no-picture"});
}

TEST_CASE("the schema of a batch refuses what contradicts itself") {
  const MixedBatch batch;
  batch.run("scenes -o out -w 40 --solutions sol");
  const json results = batch.results("out");
  const auto changed = [&](const char* pointer, const json& value) {
    json document = results;
    document[json::json_pointer(pointer)] = value;
    return faults(document);
  };
  REQUIRE(results.at("/results/0/scene"_json_pointer) == "alike.ray");
  CHECK_THAT(changed("/results/0/outcome", "done"), Catch::Contains("'done' is not one of"));
  CHECK_THAT(changed("/results/0/outcome", "crashed"), Catch::Contains("results/0"));  // with a picture
  CHECK_THAT(changed("/results/0/comparison/verdict", "good"), Catch::Contains("results/0/comparison"));
  CHECK_THAT(changed("/results/0/key", "1"), Catch::Contains("'key' was unexpected"));
  CHECK_THAT(changed("/counts/failed", -1), Catch::Contains("counts/failed"));
  CHECK_THAT(changed("/started", "yesterday"), Catch::Contains("started"));
}

}  // namespace trace::test
