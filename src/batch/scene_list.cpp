#include "batch/scene_list.hpp"

#include <fnmatch.h>

#include <algorithm>

namespace trace {
namespace {

bool any_matches(const std::vector<std::string>& patterns, const std::string& path) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& pattern) { return matches(pattern, path); });
}

}  // namespace

bool matches(const std::string& pattern, const std::string& path) {
  if (pattern.find('/') == std::string::npos && pattern != "**") {
    const std::size_t slash = path.rfind('/');
    return fnmatch(pattern.c_str(), path.c_str() + (slash == path.npos ? 0 : slash + 1), 0) == 0;
  }
  const int flags = pattern.find("**") == std::string::npos ? FNM_PATHNAME : 0;
  return fnmatch(pattern.c_str(), path.c_str(), flags) == 0;
}

std::vector<std::string> find_scenes(const std::filesystem::path& folder, const SceneFilter& filter) {
  std::vector<std::string> scenes;
  const std::vector<std::string> usual{"*.ray"};
  for (std::filesystem::recursive_directory_iterator entry(folder), end; entry != end; ++entry) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(".")) {
      entry.disable_recursion_pending();
      continue;
    }
    if (!entry->is_regular_file()) continue;
    const std::string path = entry->path().lexically_relative(folder).generic_string();
    if (any_matches(filter.include.empty() ? usual : filter.include, path) &&
        !any_matches(filter.exclude, path))
      scenes.push_back(path);
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

}  // namespace trace
