// The scenes of a folder with what its batch.json files say of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "batch/batch_files.hpp"
#include "batch/scene_list.hpp"

namespace trace {

struct FolderScene {
  std::string scene;  // its path below the folder
  SceneOptions options;
};

struct FolderScenes {
  std::vector<FolderScene> scenes;  // without those that are excluded
  std::string messages;             // complete with line ends
  bool complete = true;             // every folder below could be read
  bool valid = true;                // no batch.json has errors
};

// What a batch.json says is added to `common`. Throws std::filesystem::filesystem_error.
FolderScenes scenes_of_folder(const std::filesystem::path& folder, const SceneFilter& filter,
                              const SceneOptions& common);

}  // namespace trace
