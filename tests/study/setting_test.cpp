// The settings that a study tries.
#include "study/setting.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

namespace trace::test {
namespace {

std::vector<Axis> all_axes() {
  std::vector<Axis> axes;
  for (const AxisText& text : axis_texts) axes.push_back(text.axis);
  return axes;
}

LadderScene glass_scene() {
  LadderScene scene;
  scene.options.width = 64;
  scene.options.depth = 5;
  scene.depths = {0, 1, 2, 3, 4, 5, 6, 8};
  return scene;
}

std::vector<Setting> on_axis(const std::vector<Setting>& settings, Axis axis) {
  std::vector<Setting> result;
  std::copy_if(settings.begin(), settings.end(), std::back_inserter(result),
               [&](const Setting& s) { return s.axis == axis; });
  return result;
}

}  // namespace

TEST_CASE("each axis has its own text, in the order of the axes") {
  std::set<std::string_view> names;
  for (const AxisText& text : axis_texts) {
    CHECK(&text_of(text.axis) == &text);
    CHECK_FALSE(text.title.empty());
    CHECK_FALSE(text.text.empty());
    names.insert(text.name);
  }
  CHECK(names.size() == axis_texts.size());
}

TEST_CASE("the settings of a study have different names and begin with the course's one sample") {
  const LadderScene scene = glass_scene();
  const std::vector<Setting> settings = ladders(scene, all_axes());
  std::set<std::string> names;
  for (const Setting& setting : settings) names.insert(setting.name);
  CHECK(names.size() == settings.size());
  CHECK(settings.size() > 30);
  const Setting& base = settings.front();
  CHECK(base.name == base_setting);
  CHECK(base.options.sampling.grid == 1);
  CHECK(base.options.sampling.threshold == 0);
  CHECK_FALSE(base.options.antialiasing.enabled);
  CHECK(base.options.depth == 5);
  CHECK(base.divisor == 1);
  CHECK(base.flags == "");
  CHECK(std::none_of(settings.begin() + 1, settings.end(),
                     [](const Setting& s) { return s.text.empty() || s.name == base_setting; }));
}

TEST_CASE("a study has the axes that are asked for and uniform samples, in the order of the axes") {
  const LadderScene scene = glass_scene();
  for (const AxisText& wanted : axis_texts) {
    INFO(wanted.name);
    const std::vector<Setting> settings = ladders(scene, {wanted.axis});
    CHECK(std::all_of(settings.begin(), settings.end(),
                      [&](const Setting& s) { return s.axis == wanted.axis || s.axis == Axis::samples; }));
    CHECK_FALSE(on_axis(settings, wanted.axis).empty());
    CHECK(settings.front().name == base_setting);
  }
  const auto all = ladders(scene, {Axis::needs, Axis::depth, Axis::adaptive});
  CHECK(std::is_sorted(all.begin(), all.end(),
                       [](const Setting& a, const Setting& b) { return a.axis < b.axis; }));
}

TEST_CASE("every setting renders the scene as it is but for what its axis varies") {
  const LadderScene scene = glass_scene();
  for (const Setting& setting : ladders(scene, all_axes())) {
    INFO(setting.name);
    const RenderOptions& own = setting.options;
    CHECK(own.width == 64);
    CHECK((own.depth == 5 || setting.axis == Axis::depth || setting.axis == Axis::needs));
    CHECK((own.sampling.grid == 1 || setting.axis == Axis::samples));
    CHECK((!own.sampling.nine_points || setting.axis == Axis::patterns));
    CHECK((own.sampling.threshold == 0 || setting.axis == Axis::adaptive));
    CHECK((!own.antialiasing.enabled || setting.axis == Axis::course_adaptive));
    CHECK((own.shading.least_contribution == 0 || setting.axis == Axis::contribution));
    CHECK((!own.shading.model_everything || setting.axis == Axis::needs));
    CHECK((setting.divisor > 1) == (setting.axis == Axis::resolution));
    CHECK((setting.error_budget > 0) == (setting.axis == Axis::budget));
    CHECK(setting.arithmetic.has_value() == (setting.axis == Axis::arithmetic));
  }
}

TEST_CASE("effort grows along the ladders of samples") {
  const auto settings = ladders(glass_scene(), all_axes());
  const auto samples = on_axis(settings, Axis::samples), adaptive = on_axis(settings, Axis::adaptive),
             budgets = on_axis(settings, Axis::budget);
  for (std::size_t k = 1; k < samples.size(); ++k)
    CHECK(samples[k].options.sampling.grid > samples[k - 1].options.sampling.grid);
  for (std::size_t k = 1; k < adaptive.size(); ++k)
    CHECK(adaptive[k].options.sampling.threshold < adaptive[k - 1].options.sampling.threshold);
  for (std::size_t k = 1; k < budgets.size(); ++k)
    CHECK(budgets[k].error_budget < budgets[k - 1].error_budget);
}

TEST_CASE("the ladder of depths ends below the base setting's") {
  LadderScene scene = glass_scene();
  std::vector<int> depths;
  for (const Setting& setting : on_axis(ladders(scene, {Axis::depth}), Axis::depth))
    depths.push_back(setting.options.depth);
  CHECK(depths == std::vector<int>{0, 1, 2, 3, 4});
  scene.options.depth = 0;
  CHECK(on_axis(ladders(scene, {Axis::depth}), Axis::depth).empty());
}

TEST_CASE("where no ray has a successor there is nothing to vary of depth and contribution") {
  LadderScene scene = glass_scene();
  scene.options.depth = 0;
  scene.depths = {0};
  const auto settings = ladders(scene, all_axes());
  CHECK(on_axis(settings, Axis::depth).empty());
  CHECK(on_axis(settings, Axis::contribution).empty());
  CHECK_FALSE(on_axis(settings, Axis::adaptive).empty());
}

TEST_CASE("a picture too narrow to be divided is not") {
  LadderScene scene = glass_scene();
  scene.options.width = 3;
  const auto settings = on_axis(ladders(scene, {Axis::resolution}), Axis::resolution);
  REQUIRE(settings.size() == 1);
  CHECK(settings[0].divisor == 2);
  scene.options.width = 1;
  CHECK(on_axis(ladders(scene, {Axis::resolution}), Axis::resolution).empty());
}

}  // namespace trace::test
