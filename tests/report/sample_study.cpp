#include "tests/report/sample_study.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "comparison/judge.hpp"
#include "tests/support/picture_table.hpp"

namespace trace::test {
namespace {

using StudyJson = nlohmann::ordered_json;

struct Step {
  std::string name, axis, text, options;
  double time, error;    // relative to the first
  int supersamples = 0;  // along each axis, of its picture; 0: none
  int width = 160;
};

const std::vector<Step> steps{
    {"1", "samples", "1 sample in each pixel", "", 1, 1, 1},
    {"2x2", "samples", "2 x 2 samples in each pixel", "--aa 2", 3.9, 0.42, 2},
    {"3x3", "samples", "3 x 3 samples in each pixel", "--aa 3", 8.7, 0.25, 3},
    {"4x4", "samples", "4 x 4 samples in each pixel", "--aa 4", 15.4, 0.17},
    {"8x8", "samples", "8 x 8 samples in each pixel", "--aa 8", 61, 0.06},
    {"adaptive 4", "adaptive", "more samples where the picture is not known well, on average 4",
     "--adaptive 4", 2.1, 0.3, 4},
    {"adaptive 16", "adaptive", "more samples where the picture is not known well, on average 16",
     "--adaptive 16", 6.2, 0.11},
    {"course 3", "course adaptive", "3 x 3 samples where neighbours differ", "--course-aa 3", 2.9, 0.36},
    {"depth 2", "depth", "two reflections or refractions", "-r 2", 0.8, 1.6},
    {"depth 9", "depth", "nine reflections or refractions", "-r 9", 1.2, 0.98},
    {"contribution 0.1", "contribution", "rays that add less than a tenth are left out", "--contribution 0.1",
     0.7, 1.3},
    {"extended", "arithmetic", "extended precision", "--arithmetic extended", 9.5, 0},
    {"half", "resolution", "half the width and height, enlarged", "-w 50%", 0.3, 2.2, 1, 80},
    {"all data", "needs", "also what the scene does not need", "--all-data", 1.3, 1},
};

StudyJson axes() {
  const std::vector<std::vector<std::string>> all{
      {"samples", "Samples a pixel", "A regular grid of samples in each pixel."},
      {"adaptive", "Adaptive sampling", "More samples where the picture needs them."},
      {"course adaptive", "The course's adaptive sampling", "More samples where neighbours differ."},
      {"depth", "Depth", "How many reflections and refractions are followed."},
      {"contribution", "Contribution", "Rays that could add less than this are left out."},
      {"arithmetic", "Arithmetic", "The precision of the numbers."},
      {"resolution", "Resolution", "Fewer pixels, enlarged."},
      {"needs", "Modelling what is needed", "What is computed that the picture does not depend on."}};
  StudyJson list = StudyJson::array();
  for (const auto& axis : all) list.push_back({{"name", axis[0]}, {"title", axis[1]}, {"text", axis[2]}});
  return list;
}

StudyJson settings_of(const std::vector<Step>& some) {
  StudyJson list = StudyJson::array();
  for (const Step& step : some)
    list.push_back(
        {{"name", step.name}, {"axis", step.axis}, {"text", step.text}, {"options", step.options}});
  return list;
}

StudyJson study_of(const std::vector<Step>& some, const std::string& title) {
  return {{"format", "trace-study"},
          {"version", 1},
          {"title", title},
          {"command", "trace study scenes/ --report study.html"},
          {"started", "2026-11-22T17:00:00Z"},
          {"seconds", 312.4},
          {"program", "trace 0.1.0 (Release, g++ 12.2.0)"},
          {"machine", {{"processor", "AMD EPYC"}, {"threads", 2}, {"instruction_set", "avx512"}}},
          {"axes", axes()},
          {"settings", settings_of(some)},
          {"scenes", StudyJson::array()}};
}

StudyJson result_of(const Step& step, double ms, double rms) {
  const auto primary = std::int64_t(25600 * std::max(step.time, 0.25));
  return {{"setting", step.name},
          {"ms", {{"median", ms}, {"low", ms * 0.97}, {"high", ms * 1.04}, {"runs", 9}}},
          {"error",
           {{"rms", rms},
            {"uncertainty", 0.02},
            {"mean", rms * 0.2},
            {"largest", std::min(255.0, rms * 40)},
            {"against", step.axis == "arithmetic" ? "extended" : "converged"}}},
          {"rays",
           {{"primary", primary},
            {"reflected", primary / 3},
            {"refracted", primary / 5},
            {"shadow", primary * 2}}},
          {"memory", 12345678},
          {"front", false}};
}

double ms_of(const StudyJson& result) {
  return result["ms"]["median"];
}
double rms_of(const StudyJson& result) {
  return result["error"]["rms"];
}

void mark_front(StudyJson& results, double (*time)(const StudyJson&), double (*error)(const StudyJson&)) {
  for (StudyJson& own : results) {
    bool beaten = false;
    for (const StudyJson& other : results)
      beaten = beaten || (time(other) < time(own) && error(other) < error(own));
    own["front"] = !beaten;
  }
}

void add_gains(StudyJson& results, const std::vector<Step>& some) {
  for (std::size_t i = 1; i < results.size(); ++i) {
    if (some[i].axis != some[i - 1].axis) continue;
    results[i]["gain"] = {{"over", some[i - 1].name},
                          {"ms", ms_of(results[i]) - ms_of(results[i - 1])},
                          {"rms", rms_of(results[i]) - rms_of(results[i - 1])}};
  }
}

StudyJson fastest(const StudyJson& results) {
  StudyJson list = StudyJson::array();
  for (const double below : {4.0, 1.0, 0.25}) {
    const StudyJson* best = nullptr;
    for (const StudyJson& result : results)
      if (result["error"]["against"] == "converged" && rms_of(result) < below &&
          (!best || ms_of(result) < ms_of(*best)))
        best = &result;
    list.push_back({{"below", below}});
    if (best)
      list.back().update({{"setting", (*best)["setting"]}, {"ms", ms_of(*best)}, {"rms", rms_of(*best)}});
  }
  return list;
}

// Everything that follows from the results.
void finish_scene(StudyJson& scene, const std::vector<Step>& some) {
  mark_front(scene["results"], ms_of, rms_of);
  add_gains(scene["results"], some);
  scene["fastest"] = fastest(scene["results"]);
}

// Geometric mean of a figure relative to the first setting, over the scenes that have the setting.
double mean_ratio(const StudyJson& report, std::size_t setting, double (*value)(const StudyJson&)) {
  double sum = 0;
  int count = 0;
  for (const StudyJson& scene : report["scenes"]) {
    if (scene["results"].size() <= setting) continue;
    sum += std::log(value(scene["results"][setting]) / value(scene["results"][0]));
    ++count;
  }
  return std::exp(sum / count);
}

void finish_study(StudyJson& report, const std::vector<Step>& some) {
  StudyJson results = StudyJson::array();
  for (std::size_t i = 0; i < some.size(); ++i)
    results.push_back({{"setting", some[i].name},
                       {"time", mean_ratio(report, i, ms_of)},
                       {"error", mean_ratio(report, i, rms_of)},
                       {"scenes", report["scenes"].size()},
                       {"front", false}});
  mark_front(
      results, [](const StudyJson& result) { return result["time"].get<double>(); },
      [](const StudyJson& result) { return result["error"].get<double>(); });
  const auto claim = [&](const char* text, double times, double low, double high) {
    return StudyJson{
        {"text", text}, {"times", times}, {"low", low}, {"high", high}, {"scenes", report["scenes"].size()}};
  };
  StudyJson claims = StudyJson::array();
  claims.push_back(claim("adaptive sampling against uniform sampling at equal error", 3.4, 1.1, 9.0));
  claims.push_back(claim("modelling only what is needed", 1.8, 1.0, 2.6));
  StudyJson quickest = StudyJson::array();
  if (some.size() > 1)
    quickest.push_back({{"below", 0.5}, {"setting", some[1].name}, {"time", results[1]["time"]}});
  quickest.push_back({{"below", 0.01}});
  report["all"] = {
      {"scenes", report["scenes"].size()}, {"results", results}, {"fastest", quickest}, {"claims", claims}};
}

// A picture of a scene of ours, rendered into the folder.
std::filesystem::path study_picture(const std::filesystem::path& folder, const std::string& scene,
                                    const std::string& name, int supersamples, int width) {
  const auto source = std::filesystem::path(TRACE_SOURCE_DIR) / "scenes" / scene;
  const auto stem = folder / "study" / std::filesystem::path(scene).stem();
  std::filesystem::create_directories(stem);
  const auto file = stem / (name + ".png"), settings = stem / (name + ".json");
  write_text(
      settings,
      StudyJson({{"anti_alias", supersamples > 1}, {"supersamples", supersamples}, {"aa_threshold", 0}})
          .dump());
  const Outcome outcome =
      run_trace(source.parent_path(), "-r 5 -w " + std::to_string(width) + " -j '" + settings.string() + "'",
                {source.string(), file.string()});
  if (outcome.status != 0) throw std::runtime_error(outcome.errors);
  return file;
}

std::vector<std::uint8_t> bytes_of(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  return {text.begin(), text.end()};
}

class RenderedScene {
 public:
  RenderedScene(SampleStudy& study, const std::filesystem::path& folder, std::string scene)
      : study_(study),
        folder_(folder),
        name_(std::move(scene)),
        converged_(study_picture(folder, name_, "converged", 8, 160)) {}

  StudyJson made(double ms) {
    const Image picture = read_image(converged_);
    StudyJson scene = {{"scene", name_},
                       {"width", picture.width},
                       {"height", picture.height},
                       {"depth", 5},
                       {"converged",
                        {{"text", "16 x 16 samples, depth 9"},
                         {"samples", 256},
                         {"depth", 9},
                         {"error", 0.021},
                         {"seconds", 1.9},
                         {"picture", name_ + " converged"}}},
                       {"results", StudyJson::array()}};
    study_.pictures[name_ + " converged"] = bytes_of(converged_);
    const double first = error_of(steps[0], nullptr).value();
    for (const Step& step : steps) {
      StudyJson result = result_of(step, ms * step.time, 0);
      const double rms = error_of(step, &result).value_or(first * step.error);
      result["error"].update({{"rms", rms}, {"mean", rms * 0.2}, {"largest", std::min(255.0, rms * 20)}});
      if (step.axis == "needs") result["same_picture"] = true;
      scene["results"].push_back(std::move(result));
    }
    finish_scene(scene, steps);
    scene["chosen"] = "adaptive 4";
    return scene;
  }

  const std::filesystem::path& converged() const { return converged_; }

 private:
  // Measured where there is a picture of the right size; with its pictures, if there is a result to be
  // filled.
  std::optional<double> error_of(const Step& step, StudyJson* result) {
    if (!step.supersamples) return std::nullopt;
    const auto file = study_picture(folder_, name_, step.name, step.supersamples, step.width);
    const auto heat = file.string() + ".heat.png";
    JudgeOptions options;
    if (result) {
      options.heat_map = heat;
      (*result)["picture"] = name_ + " " + step.name;
      study_.pictures[(*result)["picture"]] = bytes_of(file);
    }
    const Judgement judgement = judge(converged_.string(), file.string(), options);
    if (result && std::filesystem::exists(heat)) {
      (*result)["heat"] = name_ + " " + step.name + " heat";
      study_.pictures[(*result)["heat"]] = bytes_of(heat);
    }
    if (!judgement.measurements) return std::nullopt;
    return judgement.measurements->error.root_mean_square;
  }

  SampleStudy& study_;
  std::filesystem::path folder_;
  std::string name_;
  std::filesystem::path converged_;
};

StudyJson made_up_scene(const std::string& name, const std::vector<Step>& some, double ms, double rms) {
  StudyJson scene = {
      {"scene", name},
      {"width", 64},
      {"height", 48},
      {"depth", 5},
      {"converged",
       {{"text", "16 x 16 samples"}, {"samples", 256}, {"depth", 9}, {"error", 0.02}, {"seconds", 0.4}}},
      {"results", StudyJson::array()}};
  for (const Step& step : some) scene["results"].push_back(result_of(step, ms * step.time, rms * step.error));
  finish_scene(scene, some);
  return scene;
}

}  // namespace

SampleStudy sample_study(const std::filesystem::path& folder) {
  SampleStudy study{study_of(steps, "scenes"), {}};
  StudyJson& list = study.report["scenes"];
  list.push_back(RenderedScene(study, folder, "features/box.ray").made(3.1));
  RenderedScene still_life(study, folder, "showcase/still_life.ray");
  list.push_back(still_life.made(24));
  list.back()["solution"] = still_life.converged().string();
  for (StudyJson& result : list.back()["results"])
    result["solution"] = {{"rms", rms_of(result) + 0.1}, {"off_by_more_than_one", 2.4}};
  list.push_back(RenderedScene(study, folder, "features/refraction.ray").made(7));
  list.push_back(
      made_up_scene("</script><img src=x onerror=alert(1)>.ray", {steps.begin(), steps.begin() + 3}, 0.4, 6));
  list.back()["solution"] = "solutions/none.png";
  finish_study(study.report, steps);
  return study;
}

StudyJson made_up_study(std::size_t scene_count, std::size_t setting_count) {
  std::vector<Step> some;
  for (std::size_t i = 0; i < setting_count; ++i) {
    Step step = steps[i % steps.size()];
    if (i >= steps.size()) {
      step.name += " again " + std::to_string(i);
      step.time *= 1 + 0.07 * double(i);
      step.error *= 1 - 0.01 * double(i);
    }
    some.push_back(step);
  }
  StudyJson report = study_of(some, "made up");
  for (std::size_t i = 0; i < scene_count; ++i)
    report["scenes"].push_back(made_up_scene("folder/scene" + std::to_string(i) + ".ray", some,
                                             1 + double(i % 17) * 3.7, 0.5 + double(i % 23) * 0.4));
  finish_study(report, some);
  return report;
}

}  // namespace trace::test
