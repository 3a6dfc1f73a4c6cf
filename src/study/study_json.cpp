#include "study/study_json.hpp"

#include <nlohmann/json.hpp>

#include "study/competition.hpp"

namespace trace {
namespace {

using Json = nlohmann::ordered_json;

// Errors that someone may ask for, in levels; and relative to the base setting's.
constexpr double asked_errors[] = {8, 4, 2, 1, 0.5, 0.25};
constexpr double asked_shares[] = {0.5, 0.25, 0.1, 0.05};

Json axes_json() {
  Json result = Json::array();
  for (const AxisText& axis : axis_texts) {
    result.push_back({{"name", axis.name}, {"title", axis.title}, {"text", axis.text}});
  }
  return result;
}

// Each setting that any scene has, by axis.
Json settings_json(std::span<const SceneResult> scenes) {
  Json result = Json::array();
  for (const Setting* setting : settings_of(scenes)) {
    result.push_back({{"name", setting->name},
                      {"axis", text_of(setting->axis).name},
                      {"text", setting->text},
                      {"options", setting->flags}});
  }
  return result;
}

Json rays_json(const RayCounts& rays) {
  return {{"primary", rays.primary},
          {"reflected", rays.reflected},
          {"refracted", rays.refracted},
          {"shadow", rays.shadow}};
}

// `before`: the step before on its axis; null for the first.
Json result_json(const SettingResult& own, const SettingResult* before) {
  Json result = {{"setting", own.setting.name},
                 {"ms",
                  {{"median", own.time.median},
                   {"low", own.time.low},
                   {"high", own.time.high},
                   {"runs", own.time.runs}}},
                 {"error",
                  {{"rms", own.error.root_mean_square},
                   {"uncertainty", own.uncertainty},
                   {"mean", own.error.mean_absolute},
                   {"largest", own.error.largest},
                   {"against", own.setting.arithmetic ? "extended" : "converged"}}}};
  if (own.solution) {
    result["solution"] = {{"rms", own.solution->root_mean_square},
                          {"off_by_more_than_one", own.solution->percent_over_one}};
  }
  result["rays"] = rays_json(own.rays);
  result["memory"] = own.memory;
  result["front"] = own.front;
  if (before) {
    result["gain"] = {{"over", before->setting.name},
                      {"ms", own.time.median - before->time.median},
                      {"rms", own.error.root_mean_square - before->error.root_mean_square}};
  }
  if (own.same_picture) result["same_picture"] = *own.same_picture;
  if (!own.picture.empty()) result["picture"] = own.picture;
  if (!own.heat_map.empty()) result["heat"] = own.heat_map;
  return result;
}

// The first step of an axis follows the base setting, but on axes whose steps are not refinements of it.
const SettingResult* step_before(const SceneResult& scene, std::size_t k) {
  const Axis axis = scene.settings[k].setting.axis;
  if (k > 0 && scene.settings[k - 1].setting.axis == axis) return &scene.settings[k - 1];
  const bool refines = axis == Axis::adaptive || axis == Axis::course_adaptive;
  return refines ? &scene.settings.front() : nullptr;
}

Json fastest_json(const SceneResult& scene) {
  Json result = Json::array();
  for (const double error : asked_errors) {
    Json line = {{"below", error}};
    if (const SettingResult* own = fastest_within(scene, error)) {
      line["setting"] = own->setting.name;
      line["ms"] = own->time.median;
      line["rms"] = own->error.root_mean_square;
    }
    result.push_back(line);
  }
  return result;
}

Json scene_json(const SceneResult& scene) {
  Json result = {
      {"scene", scene.scene}, {"width", scene.width}, {"height", scene.height}, {"depth", scene.depth}};
  const ConvergedText& truth = scene.converged;
  result["converged"] = {
      {"text", std::to_string(truth.samples) + " samples a pixel, depth " + std::to_string(truth.depth)},
      {"samples", truth.samples},
      {"depth", truth.depth},
      {"error", truth.error},
      {"seconds", truth.seconds}};
  if (truth.unsettled > 0) result["converged"]["unsettled"] = truth.unsettled;
  if (!truth.picture.empty()) result["converged"]["picture"] = truth.picture;
  if (!scene.solution.empty()) result["solution"] = scene.solution;
  Json results = Json::array();
  for (std::size_t k = 0; k < scene.settings.size(); ++k) {
    results.push_back(result_json(scene.settings[k], step_before(scene, k)));
  }
  result["results"] = std::move(results);
  result["fastest"] = fastest_json(scene);
  result["chosen"] = scene.settings[scene.chosen].setting.name;
  return result;
}

Json overall_json(const Overall& all) {
  Json results = Json::array();
  std::vector<Cost> costs;
  for (const OverallSetting& own : all.settings) {
    results.push_back({{"setting", own.name},
                       {"time", own.time},
                       {"error", own.error},
                       {"scenes", own.scenes},
                       {"front", own.front}});
    costs.push_back({own.time, own.error});
  }
  Json fastest = Json::array();
  for (const double share : asked_shares) {
    Json line = {{"below", share}};
    if (const int best = fastest_within(costs, share); best >= 0) {
      const OverallSetting& own = all.settings[static_cast<std::size_t>(best)];
      line["setting"] = own.name;
      line["time"] = own.time;
    }
    fastest.push_back(line);
  }
  Json claims = Json::array();
  for (const Claim& claim : all.claims) {
    claims.push_back({{"text", claim.text},
                      {"times", claim.times},
                      {"low", claim.low},
                      {"high", claim.high},
                      {"scenes", claim.scenes}});
  }
  Json budgets = Json::array();
  for (const BudgetKept& own : all.budgets) {
    budgets.push_back({{"asked", own.asked},
                       {"scenes", own.scenes},
                       {"within", own.within},
                       {"nearly", own.nearly},
                       {"worst", own.worst}});
  }
  return {{"scenes", all.scenes},
          {"results", results},
          {"fastest", fastest},
          {"claims", claims},
          {"budgets", budgets}};
}

}  // namespace

Json study_json(const StudyInfo& info, std::span<const SceneResult> scenes, const Overall& all) {
  Json result = {
      {"format", "trace-study"},
      {"version", 1},
      {"title", info.title},
      {"command", info.command},
      {"started", info.started},
      {"seconds", info.seconds},
      {"program", info.program},
      {"machine",
       {{"processor", info.processor}, {"threads", info.threads}, {"instruction_set", info.instruction_set}}},
      {"axes", axes_json()},
      {"settings", settings_json(scenes)}};
  Json list = Json::array();
  for (const SceneResult& scene : scenes) list.push_back(scene_json(scene));
  result["scenes"] = std::move(list);
  result["all"] = overall_json(all);
  return result;
}

}  // namespace trace
