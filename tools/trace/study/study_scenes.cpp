#include "tools/trace/study/study_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "batch/folder_scenes.hpp"
#include "batch/solutions.hpp"
#include "image/image.hpp"
#include "loading/settings_file.hpp"

namespace trace {
namespace {

namespace fs = std::filesystem;

class StudyPlanner {
 public:
  explicit StudyPlanner(const StudyArguments& arguments)
      : arguments_(arguments), solutions_(arguments.solutions) {}

  StudyPlan plan() {
    std::error_code ignored;
    if (!arguments_.solutions.empty() && !fs::is_directory(arguments_.solutions, ignored))
      throw StudyPlanError(fmt::format("trace: error: '{}' is not a folder\n", arguments_.solutions));
    if (!arguments_.settings.empty()) {
      const SettingsFile file = read_settings(arguments_.settings);
      if (!file.valid) throw StudyPlanError(file.messages);
      plan_.warnings += file.messages;
      common_.settings.push_back(file);
    }
    if (!arguments_.cube_map.empty()) common_.cube_map = arguments_.cube_map;
    for (const std::string& what : arguments_.scenes) {
      if (fs::is_directory(what, ignored)) {
        add_folder(what);
      } else {
        // Solutions are named after the path as it is given, or the file alone.
        fs::path solution = solution_of(what);
        if (solution.empty()) solution = solution_of(fs::path(what).filename().string());
        add(what, what, solution, common_);
      }
    }
    return std::move(plan_);
  }

 private:
  void add_folder(const std::string& folder) {
    const FolderScenes found = scenes_of_folder(folder, {}, common_);
    plan_.warnings += found.messages;
    plan_.incomplete |= !found.complete;
    const bool alone = arguments_.scenes.size() == 1;
    for (const auto& [scene, options] : found.scenes) {
      const std::string file = (fs::path(folder) / scene).string();
      add(alone ? scene : file, file, solution_of(scene), options);
    }
    if (!found.valid) throw StudyPlanError(plan_.warnings);
  }

  fs::path solution_of(const std::string& scene) {
    return arguments_.solutions.empty() ? fs::path() : solutions_.find(scene);
  }

  void add(const std::string& name, const std::string& file, const fs::path& solution,
           const SceneOptions& own) {
    StudyScene scene;
    scene.name = name;
    scene.file = file;
    scene.options = arguments_.options;
    // What a scene asks for is for its picture; here the command line decides how large and deep.
    const int width = scene.options.width, depth = scene.options.depth, threads = scene.options.threads;
    for (const Settings& settings : own.settings) settings.apply(scene.options);
    scene.options.width = width, scene.options.depth = depth, scene.options.threads = threads;
    scene.options.antialiasing = {};
    scene.options.blocks = {};
    scene.fixed_depth = arguments_.depth_given;
    scene.cube_map = own.cube_map.value_or("");
    scene.solution = solution;
    if (!solution.empty() && !arguments_.width_given) {
      try {
        scene.options.width = read_image(solution).width;
      } catch (const ImageError& e) {
        throw StudyPlanError(
            fmt::format("trace: error: cannot read '{}': {}\n", solution.string(), e.what()));
      }
    }
    plan_.scenes.push_back(std::move(scene));
  }

  const StudyArguments& arguments_;
  Solutions solutions_;
  SceneOptions common_;
  StudyPlan plan_;
};

}  // namespace

StudyPlan plan_study(const StudyArguments& arguments) {
  return StudyPlanner(arguments).plan();
}

}  // namespace trace
