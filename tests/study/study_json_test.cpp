// The results of a study as JSON: what is in them, and that they fit the published schema.
#include "study/study_json.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/study/made_results.hpp"
#include "tests/support/run_python.hpp"

namespace trace::test {
namespace {

StudyInfo made_info() {
  return {"scenes", "trace study scenes", "2026-11-22T17:00:00Z", "trace 0.1", "a processor", "avx2", 2, 1.5};
}

// With every member that there may be.
SceneResult full_scene() {
  SceneResult scene = made_scene("a.ray", made_uniform());
  scene.converged.picture = "a.ray converged";
  scene.solution = "sol/a.png";
  scene.settings[0].solution = SolutionError{1.5, 12.5};
  scene.settings[0].rays = {256, 10, 20, 300, {}};
  scene.settings[0].memory = 12345678;
  scene.settings[0].front = true;
  scene.settings[1].picture = "a.ray 2x2";
  scene.settings[1].heat_map = "a.ray 2x2 heat";
  scene.settings.push_back(made_setting("adaptive 8", Axis::adaptive, 3, 3));
  scene.settings.back().setting.flags = "--adaptive 8";
  scene.settings.push_back(made_budget(2, 1.9));
  scene.settings.push_back(made_setting("depth 1", Axis::depth, 0.5, 20));
  scene.settings.push_back(made_setting("float", Axis::arithmetic, 2, 0.1));
  scene.settings.back().setting.arithmetic = Arithmetic::single;
  scene.settings.push_back(made_setting("needed", Axis::needs, 1, 8));
  scene.settings.push_back(made_setting("everything", Axis::needs, 3, 8));
  scene.settings.back().same_picture = true;
  scene.chosen = 1;
  return scene;
}

nlohmann::ordered_json json_of(const std::vector<SceneResult>& scenes) {
  return study_json(made_info(), scenes, overall(scenes));
}

const nlohmann::ordered_json& with_name(const nlohmann::ordered_json& list, const std::string& key,
                                        const std::string& value) {
  for (const auto& own : list) {
    if (own.at(key) == value) return own;
  }
  throw std::runtime_error("no " + value);
}

}  // namespace

TEST_CASE("what a study writes fits its published schema") {
  const std::vector<SceneResult> scenes{full_scene(), made_scene("b.ray", made_uniform()),
                                        made_scene("black.ray", {made_setting("1", Axis::samples, 1, 0)})};
  CHECK(schema_faults("study-1.schema.json", json_of(scenes).dump()) == "");
}

TEST_CASE("a study's JSON names every axis, and every setting once with its axis and options") {
  const auto json = json_of({made_scene("b.ray", made_uniform()), full_scene()});
  CHECK(json.at("axes").size() == axis_texts.size());
  CHECK(json.at("settings").size() == full_scene().settings.size());
  const auto& adaptive = with_name(json.at("settings"), "name", "adaptive 8");
  CHECK(adaptive.at("axis") == "adaptive");
  CHECK(adaptive.at("options") == "--adaptive 8");
  CHECK(json.at("machine").at("threads") == 2);
  CHECK(json.at("command") == "trace study scenes");
}

TEST_CASE("a result has its time, errors, rays and what it gains over the step before") {
  const auto json = json_of({full_scene()});
  const auto& scene = json.at("scenes").at(0);
  CHECK(scene.at("chosen") == "2x2");
  CHECK(scene.at("solution") == "sol/a.png");
  const auto& results = scene.at("results");
  const auto& one = with_name(results, "setting", "1");
  CHECK(one.at("ms").at("median") == 1);
  CHECK(one.at("ms").at("runs") == 5);
  CHECK(one.at("error").at("rms") == 8);
  CHECK(one.at("error").at("against") == "converged");
  CHECK(one.at("solution").at("off_by_more_than_one") == 12.5);
  CHECK(one.at("rays").at("shadow") == 300);
  CHECK(one.at("memory") == 12345678);
  CHECK(one.at("front") == true);
  CHECK_FALSE(one.contains("gain"));
  const auto& two = with_name(results, "setting", "2x2");
  CHECK(two.at("gain").at("over") == "1");
  CHECK(two.at("gain").at("ms") == 3);
  CHECK(two.at("gain").at("rms") == -4);
  CHECK(two.at("heat") == "a.ray 2x2 heat");
  CHECK_FALSE(two.contains("solution"));
  // Of adaptive sampling one sample is the step before; of depths nothing is.
  CHECK(with_name(results, "setting", "adaptive 8").at("gain").at("over") == "1");
  CHECK_FALSE(with_name(results, "setting", "depth 1").contains("gain"));
  CHECK(with_name(results, "setting", "float").at("error").at("against") == "extended");
  CHECK(with_name(results, "setting", "everything").at("same_picture") == true);
}

TEST_CASE("the fastest for an error is of settings that make the same picture otherwise, or is absent") {
  const auto json = json_of({full_scene()});
  const auto& fastest = json.at("scenes").at(0).at("fastest");
  const auto below = [&](double error) {
    for (const auto& own : fastest) {
      if (own.at("below") == error) return own;
    }
    throw std::runtime_error("no such error");
  };
  CHECK(below(8).at("setting") == "1");
  CHECK(below(4).at("setting") == "adaptive 8");
  CHECK(below(4).at("ms") == 3);
  CHECK(below(2).at("rms") == 1.9);
  CHECK_FALSE(below(1).contains("setting"));  // not "float", whose error is another
}

TEST_CASE("a study's JSON has what holds over all scenes, budgets among it") {
  const auto json = json_of({full_scene(), made_scene("b.ray", made_uniform())});
  const auto& all = json.at("all");
  CHECK(all.at("scenes") == 2);
  CHECK(with_name(all.at("results"), "setting", "2x2").at("time") == Approx(4));
  REQUIRE(all.at("budgets").size() == 1);
  const auto& budget = all.at("budgets").at(0);
  CHECK(budget.at("asked") == 2);
  CHECK(budget.at("scenes") == 1);
  CHECK(budget.at("within") == 1);
  CHECK(budget.at("nearly") == 1);
  CHECK(budget.at("worst") == Approx(0.95));
  CHECK(all.at("claims").size() == 2);
}

}  // namespace trace::test
