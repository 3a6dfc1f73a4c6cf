#include "scene/scene_files.hpp"

#include <algorithm>

namespace trace {
namespace {

constexpr char windows_separator = '\\';

bool is_windows(const std::string& name) {
  return name.find(windows_separator) != std::string::npos;
}

std::string with_slashes(std::string name) {
  std::replace(name.begin(), name.end(), windows_separator, '/');
  return name;
}

}  // namespace

std::filesystem::path SceneFiles::find(const std::string& name, bool or_working_folder) const {
  std::filesystem::path path = folder_ / name;
  if (!or_working_folder && !is_windows(name)) return path;
  if (images_.exists(path)) return path;
  if (is_windows(name) && images_.exists(folder_ / with_slashes(name))) return folder_ / with_slashes(name);
  if (!or_working_folder) return path;
  if (images_.exists(name)) return name;
  if (is_windows(name) && images_.exists(with_slashes(name))) return with_slashes(name);
  return path;
}

std::filesystem::path SceneFiles::find_somewhere(const std::string& name) const {
  std::filesystem::path path = find(name);
  if (images_.exists(path)) return path;
  constexpr int most_folders = 64;
  std::string rest = with_slashes(name);
  for (int i = 0; i < most_folders; ++i) {
    const std::size_t slash = rest.find('/');
    if (slash == std::string::npos) break;
    rest.erase(0, slash + 1);
    if (!rest.empty() && images_.exists(folder_ / rest)) return folder_ / rest;
  }
  return path;
}

}  // namespace trace
