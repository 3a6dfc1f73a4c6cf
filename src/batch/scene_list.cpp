#include "batch/scene_list.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>

#include "image/image_source.hpp"
#include "image/system_error.hpp"

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

SceneList find_scenes(const std::filesystem::path& folder, const SceneFilter& filter) {
  namespace fs = std::filesystem;
  SceneList found;
  const std::vector<std::string> usual{"*.ray"};
  std::vector<fs::path> folders{folder};
  while (!folders.empty()) {
    const fs::path here = folders.back();
    folders.pop_back();
    std::error_code error;
    for (const fs::path& entry : FileImages().list(here, error)) {
      if (entry.filename().string().starts_with(".")) continue;
      std::error_code ignored;
      const fs::file_status link = fs::symlink_status(entry, ignored);
      if (fs::is_directory(link)) folders.push_back(entry);
      if (!fs::is_regular_file(fs::status(entry, ignored))) continue;
      const std::string path = entry.lexically_relative(folder).generic_string();
      if (any_matches(filter.include.empty() ? usual : filter.include, path) &&
          !any_matches(filter.exclude, path))
        found.scenes.push_back(path);
    }
    if (error)
      found.problems.push_back(
          fmt::format("cannot read the folder '{}': {}", here.string(), system_reason(error.value())));
  }
  std::sort(found.scenes.begin(), found.scenes.end());
  return found;
}

}  // namespace trace
