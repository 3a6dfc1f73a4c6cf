// Which scenes a batch renders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace trace {

// A pattern as of the shell, for a path below the batch's folder: `*` and `?` do not match `/`, `**` does,
// and a pattern without `/` is for the file's name alone: "box*" is any scene so called, "simple/*" those of
// a folder.
bool matches(const std::string& pattern, const std::string& path);

struct SceneFilter {
  std::vector<std::string> include;  // empty: every file that ends in .ray
  std::vector<std::string> exclude;
};

struct SceneList {
  std::vector<std::string> scenes;
  std::vector<std::string> problems;  // "cannot read the folder 'x': permission denied"
};

// The paths, relative to `folder`, of all scenes in it and the folders below, in order of their names. Hidden
// files and folders, and folders behind symbolic links, are passed over. Throws
// std::filesystem::filesystem_error.
SceneList find_scenes(const std::filesystem::path& folder, const SceneFilter& filter);

}  // namespace trace
