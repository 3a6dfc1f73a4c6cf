#include "tests/report/sample_batch.hpp"

#include <stdexcept>

#include "comparison/judge.hpp"
#include "report/comparison_json.hpp"
#include "tests/support/picture_table.hpp"

namespace trace::test {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

const fs::path scenes = fs::path(TRACE_SOURCE_DIR) / "scenes";

struct Sample {
  std::string scene;
  std::string defect;  // settings of the program for our picture, in JSON
  std::string arguments = "-r 5 -w 160";
  std::string diagnosis = {};  // its kind and its text are the same here
};

const std::vector<Sample> samples{
    {"features/sphere.ray", "{}"},
    {"features/cylinder.ray", "{}"},
    {"features/reflection.ray", "{}", "-r 0 -w 160", "reflection is missing"},
    {"showcase/still_life.ray", R"({"shadows": false})", "-r 5 -w 160", "shadows are missing"},
    {"features/trimesh_normals.ray", R"({"smoothshade": false})"},
    {"features/cone.ray", "{}", "-r 5 -w 96"},
    {"features/refraction.ray", "{}"},
    {"features/specular.ray", "{}"},
};

void render(const fs::path& scene, const std::string& arguments, const std::string& settings,
            const fs::path& picture) {
  fs::create_directories(picture.parent_path());
  const fs::path file = picture.string() + ".json";
  write_text(file, settings);
  const Outcome outcome =
      run_trace(scene.parent_path(), arguments + " -j '" + file.string() + "'", {scene.string(), picture});
  if (outcome.status != 0) throw std::runtime_error(outcome.errors);
}

Json result(const std::string& scene, const std::string& outcome, double seconds) {
  return {{"scene", scene},     {"renderer", "trace"},  {"outcome", outcome}, {"message", ""},
          {"depth", 5},         {"width", 160},         {"seconds", seconds}, {"cpu_seconds", seconds},
          {"memory_mib", 20.5}, {"rays", 12345},        {"picture", nullptr}, {"solution", nullptr},
          {"heat", nullptr},    {"comparison", nullptr}};
}

// Of the result's picture with its solution, with a heat map where they differ.
void compare(Json& result) {
  const std::string picture = result["picture"], heat = picture + ".heat.png";
  fs::remove(heat);
  JudgeOptions options;
  options.heat_map = heat;
  result["comparison"] = comparison_json(judge(result["solution"].get<std::string>(), picture, options));
  result["heat"] = fs::exists(heat) ? Json(heat) : Json();
}

Json rendered(const fs::path& folder, const Sample& sample, double seconds) {
  const fs::path stem = fs::path(sample.scene).replace_extension(".png");
  const fs::path picture = folder / "out" / stem, solution = folder / "solutions" / stem;
  render(scenes / sample.scene, sample.arguments, sample.defect, picture);
  render(scenes / sample.scene, "-r 5 -w 160", "{}", solution);
  Json made = result(sample.scene, "rendered", seconds);
  made["picture"] = picture.string();
  made["solution"] = solution.string();
  compare(made);
  if (!sample.diagnosis.empty())
    made["comparison"]["diagnosis"] = {{"kind", sample.diagnosis}, {"text", sample.diagnosis}};
  return made;
}

// A picture that is right but for one level in its first pixel.
Json within_tolerance(const fs::path& folder) {
  Json made = rendered(folder, {"features/box.ray", "{}"}, 0.02);
  const std::string file = made["picture"];
  Image ours = read_image(file);
  ours.rgb[0] = std::uint8_t(ours.rgb[0] ^ 1);
  write_image(file, ours);
  compare(made);
  return made;
}

Json half_a_picture(const fs::path& folder) {
  Json made = rendered(folder, {"features/groups.ray", "{}"}, 0.03);
  const std::string picture = made["picture"];
  const std::string whole = read_text(picture);
  write_text(picture, whole.substr(0, whole.size() / 2));
  made["outcome"] = "bad-picture";
  made["message"] = "the picture ends too early";
  made["comparison"] = nullptr;
  return made;
}

Json syntax_error(const fs::path& folder) {
  const fs::path scene = folder / "wrong.ray";
  write_text(scene, "SBT-raytracer 1.0\nsphere { material = { difuse = (1, 0, 0); } }\n");
  Json made = result("wrong.ray", "failed", 0.004);
  made["message"] = run_trace(folder, "-w 16", {"wrong.ray", (folder / "wrong.png").string()}).errors;
  made["rays"] = nullptr;
  return made;
}

}  // namespace

Json sample_batch(const fs::path& folder) {
  Json report = {{"format", "trace-batch"},
                 {"version", 1},
                 {"title", "sample"},
                 {"command", "trace batch scenes -o out --solutions solutions --report report.html"},
                 {"started", "2026-11-22T04:13:05Z"},
                 {"seconds", 1.25},
                 {"interrupted", false},
                 {"renderers", {"trace"}},
                 {"counts", Json::object()},
                 {"results", Json::array()}};
  Json& results = report["results"];
  double seconds = 0.01;
  for (const Sample& sample : samples) results.push_back(rendered(folder, sample, seconds *= 1.7));
  results.push_back(within_tolerance(folder));
  results.push_back(half_a_picture(folder));
  results.push_back(syntax_error(folder));
  results.push_back(result("deep/recursion.ray", "crashed", 0.3));
  results.push_back(result("</script><img src=x onerror=alert(1)>.ray", "no-picture", 0.1));
  return report;
}

Json with_second_renderer(Json report) {
  const std::string name = "./student -r {depth} {scene} {out}";
  Json others = Json::array();
  for (Json other : report["results"]) {
    other["renderer"] = name;
    if (other["scene"] == "features/refraction.ray") {
      other["outcome"] = "timeout";
      other["picture"] = other["comparison"] = nullptr;
    } else if (other["solution"].is_string()) {
      other["outcome"] = "rendered";
      other["message"] = "";
      other["picture"] = other["solution"];
      compare(other);
    }
    others.push_back(std::move(other));
  }
  report["renderers"].push_back(name);
  for (Json& other : others) report["results"].push_back(std::move(other));
  return report;
}

}  // namespace trace::test
