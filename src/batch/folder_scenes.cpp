#include "batch/folder_scenes.hpp"

#include <fmt/format.h>

namespace trace {

FolderScenes scenes_of_folder(const std::filesystem::path& folder, const SceneFilter& filter,
                              const SceneOptions& common) {
  FolderScenes result;
  const SceneList list = find_scenes(folder, filter);
  for (const std::string& problem : list.problems)
    result.messages += fmt::format("trace: error: {}\n", problem);
  result.complete = list.problems.empty();
  BatchFiles files(folder, result.messages);
  for (const std::string& scene : list.scenes) {
    const auto own = files.of(scene);
    if (!own) continue;
    SceneOptions options = common;
    options.add(*own);
    result.scenes.push_back({scene, std::move(options)});
  }
  result.valid = files.valid();
  return result;
}

}  // namespace trace
