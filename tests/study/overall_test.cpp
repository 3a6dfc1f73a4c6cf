// What a study says over all its scenes, on results made by hand.
#include "study/overall.hpp"

#include <catch2/catch.hpp>

#include "tests/study/made_results.hpp"

namespace trace::test {
namespace {

const OverallSetting& line_of(const Overall& all, const std::string& name) {
  for (const OverallSetting& own : all.settings) {
    if (own.name == name) return own;
  }
  throw std::runtime_error("no setting " + name);
}

bool has_line(const Overall& all, const std::string& name) {
  return std::any_of(all.settings.begin(), all.settings.end(),
                     [&](const OverallSetting& own) { return own.name == name; });
}

const Claim& claim_with(const Overall& all, const std::string& words) {
  for (const Claim& claim : all.claims) {
    if (claim.text.find(words) != claim.text.npos) return claim;
  }
  throw std::runtime_error("no claim with " + words);
}

// One sample in 1 ms, and an adaptive setting so many times as fast as uniform sampling of its error.
SceneResult faster_scene(double times) {
  SceneResult scene = made_scene("a.ray", made_uniform());
  scene.settings.push_back(made_setting("adaptive", Axis::adaptive, 64 / 9.0 / times, 3));
  return scene;
}

}  // namespace

TEST_CASE("times and errors of all scenes are geometric means relative to one sample a pixel") {
  const std::vector<SceneResult> scenes{made_scene("a.ray", {made_setting("1", Axis::samples, 10, 4),
                                                             made_setting("2x2", Axis::samples, 20, 2)}),
                                        made_scene("b.ray", {made_setting("1", Axis::samples, 1, 9),
                                                             made_setting("2x2", Axis::samples, 8, 1)})};
  const Overall all = overall(scenes);
  CHECK(all.scenes == 2);
  CHECK(line_of(all, "1").time == Approx(1));
  CHECK(line_of(all, "1").error == Approx(1));
  CHECK(line_of(all, "2x2").time == Approx(4));  // of 2 and 8
  CHECK(line_of(all, "2x2").error == Approx(std::sqrt(0.5 / 9)));
  CHECK(line_of(all, "2x2").scenes == 2);
}

TEST_CASE("a setting that only some scenes have counts those") {
  const std::vector<SceneResult> scenes{made_scene("a.ray", {made_setting("1", Axis::samples, 1, 4),
                                                             made_setting("depth 1", Axis::depth, 0.5, 8)}),
                                        made_scene("b.ray", {made_setting("1", Axis::samples, 1, 4)})};
  const Overall all = overall(scenes);
  CHECK(line_of(all, "depth 1").scenes == 1);
  CHECK(line_of(all, "depth 1").error == Approx(2));
  CHECK(line_of(all, "1").scenes == 2);
}

TEST_CASE("settings are in the order of the axes, whichever scene has them first") {
  const std::vector<SceneResult> scenes{
      made_scene("a.ray",
                 {made_setting("1", Axis::samples, 1, 4), made_setting("depth 1", Axis::depth, 1, 4)}),
      made_scene("b.ray",
                 {made_setting("1", Axis::samples, 1, 4), made_setting("adaptive 4", Axis::adaptive, 1, 4)})};
  const Overall all = overall(scenes);
  REQUIRE(all.settings.size() == 3);
  CHECK(all.settings[1].name == "adaptive 4");
  CHECK(all.settings[2].name == "depth 1");
}

TEST_CASE("scenes whose base setting is not off say nothing of errors and are left out") {
  const std::vector<SceneResult> scenes{
      made_scene("black.ray",
                 {made_setting("1", Axis::samples, 1, 0), made_setting("2x2", Axis::samples, 50, 0)}),
      made_scene("unsure.ray", {made_setting("1", Axis::samples, 1, 0.1, 0.06),
                                made_setting("2x2", Axis::samples, 50, 0.1, 0.06)}),
      made_scene("a.ray",
                 {made_setting("1", Axis::samples, 1, 4), made_setting("2x2", Axis::samples, 3, 2)})};
  const Overall all = overall(scenes);
  CHECK(all.scenes == 3);
  CHECK(line_of(all, "2x2").scenes == 1);
  CHECK(line_of(all, "2x2").time == Approx(3));
  CHECK(overall(std::span(scenes).first(1)).settings.empty());
}

TEST_CASE("an error below the converged picture's own counts as that") {
  const std::vector<SceneResult> scenes{made_scene(
      "a.ray",
      {made_setting("1", Axis::samples, 1, 4, 0.5), made_setting("8x8", Axis::samples, 64, 0.01, 0.5)})};
  CHECK(line_of(overall(scenes), "8x8").error == Approx(0.5 / 4));
}

TEST_CASE("the front over all scenes is that of the means") {
  const std::vector<SceneResult> scenes{
      made_scene("a.ray", {made_setting("1", Axis::samples, 1, 4), made_setting("2x2", Axis::samples, 4, 2),
                           made_setting("adaptive", Axis::adaptive, 3, 1)})};
  const Overall all = overall(scenes);
  CHECK(line_of(all, "1").front);
  CHECK(line_of(all, "adaptive").front);
  CHECK_FALSE(line_of(all, "2x2").front);
}

TEST_CASE("the speed-up at equal error is read off the curve of uniform sampling between its steps") {
  // Uniform sampling with an error of 3 would take 64 / 9.
  CHECK(speed_up_at_equal_error(faster_scene(2.5), Axis::adaptive) == Approx(2.5));
  CHECK(speed_up_at_equal_error(faster_scene(0.5), Axis::adaptive) == Approx(0.5));
  SceneResult at_a_step = made_scene("a.ray", made_uniform());
  at_a_step.settings.push_back(made_setting("adaptive", Axis::adaptive, 2, 4));
  CHECK(speed_up_at_equal_error(at_a_step, Axis::adaptive) == Approx(2));
  at_a_step.settings.push_back(made_setting("finer", Axis::adaptive, 2, 2));  // 16 / 2
  CHECK(speed_up_at_equal_error(at_a_step, Axis::adaptive) == Approx(4));     // of 2 and 8
}

TEST_CASE("there is no speed-up where errors are not comparable") {
  SceneResult scene = made_scene("a.ray", made_uniform());
  CHECK(speed_up_at_equal_error(scene, Axis::adaptive) == 0);
  scene.settings.push_back(made_setting("worse than any", Axis::adaptive, 1, 9));
  scene.settings.push_back(made_setting("better than any", Axis::adaptive, 1, 1));
  scene.settings.push_back(made_setting("as good as the truth", Axis::adaptive, 1, 3, 2));
  CHECK(speed_up_at_equal_error(scene, Axis::adaptive) == 0);
  SceneResult black =
      made_scene("b.ray", {made_setting("1", Axis::samples, 1, 0), made_setting("2x2", Axis::samples, 4, 0),
                           made_setting("adaptive", Axis::adaptive, 1, 0)});
  CHECK(speed_up_at_equal_error(black, Axis::adaptive) == 0);
}

TEST_CASE("steps of uniform sampling that make the error no smaller are no part of its curve") {
  SceneResult scene =
      made_scene("a.ray", {made_setting("1", Axis::samples, 1, 8), made_setting("2x2", Axis::samples, 100, 8),
                           made_setting("3x3", Axis::samples, 4, 4)});
  scene.settings.push_back(made_setting("adaptive", Axis::adaptive, 1, 4));
  CHECK(speed_up_at_equal_error(scene, Axis::adaptive) == Approx(4));
}

TEST_CASE("a claim is the geometric mean over the scenes that have it, with its extremes") {
  const std::vector<SceneResult> scenes{faster_scene(2), faster_scene(8),
                                        made_scene("none.ray", made_uniform())};
  const Overall all = overall(scenes);
  const Claim& adaptive = claim_with(all, "adaptive sampling against uniform");
  CHECK(adaptive.times == Approx(4));
  CHECK(adaptive.low == Approx(2));
  CHECK(adaptive.high == Approx(8));
  CHECK(adaptive.scenes == 2);
  CHECK(all.claims.size() == 1);  // nothing is claimed of axes that were not studied
}

TEST_CASE("arithmetic and needs have claims, and no line among the settings") {
  SceneResult scene = made_scene("a.ray", made_uniform());
  scene.settings.push_back(made_setting("float", Axis::arithmetic, 2, 0.1));
  scene.settings.back().setting.arithmetic = Arithmetic::single;
  scene.settings.push_back(made_setting("double", Axis::arithmetic, 5, 0.001));
  scene.settings.back().setting.arithmetic = Arithmetic::working;
  scene.settings.push_back(made_setting("needed", Axis::needs, 1, 8));
  scene.settings.push_back(made_setting("everything", Axis::needs, 3, 8));
  const Overall all = overall(std::vector{scene});
  CHECK(claim_with(all, "float").times == Approx(2.5));
  CHECK(claim_with(all, "modelling only").times == Approx(3));
  for (const char* name : {"float", "double", "everything"}) CHECK_FALSE(has_line(all, name));
  CHECK(has_line(all, "4x4"));
}

TEST_CASE("budgets are counted by what was asked: kept, nearly kept, and the worst") {
  const std::vector<SceneResult> scenes{
      made_scene("a.ray", {made_setting("1", Axis::samples, 1, 8), made_budget(2, 1.5), made_budget(1, 1)}),
      made_scene("b.ray", {made_setting("1", Axis::samples, 1, 8), made_budget(2, 2.9), made_budget(1, 0)}),
      made_scene("c.ray", {made_setting("1", Axis::samples, 1, 8), made_budget(2, 5)})};
  const Overall all = overall(scenes);
  REQUIRE(all.budgets.size() == 2);
  CHECK(all.budgets[0].asked == 2);
  CHECK(all.budgets[0].scenes == 3);
  CHECK(all.budgets[0].within == 1);
  CHECK(all.budgets[0].nearly == 2);
  CHECK(all.budgets[0].worst == Approx(2.5));
  CHECK(all.budgets[1].asked == 1);
  CHECK(all.budgets[1].scenes == 2);
  CHECK(all.budgets[1].within == 2);
  CHECK(all.budgets[1].nearly == 2);
  CHECK(all.budgets[1].worst == Approx(1));
}

TEST_CASE("of no scenes nothing is said") {
  const Overall none = overall({});
  CHECK(none.scenes == 0);
  CHECK(none.settings.empty());
  CHECK(none.claims.empty());
  CHECK(none.budgets.empty());
}

}  // namespace trace::test
