#include "batch/batch_files.hpp"

#include "batch/scene_list.hpp"

namespace trace {

std::optional<SceneOptions> BatchFiles::of(const std::string& scene) {
  SceneOptions result;
  std::filesystem::path folder, rest = scene;
  for (;;) {
    if (const auto& file = in(folder)) {
      const std::string path = rest.generic_string();
      for (const std::string& pattern : file->exclude()) {
        if (matches(pattern, path)) return std::nullopt;
      }
      result.add(file->of(path));
    }
    if (!rest.has_parent_path()) return result;
    folder /= *rest.begin();
    rest = rest.lexically_relative(*rest.begin());
  }
}

const std::optional<BatchFile>& BatchFiles::in(const std::filesystem::path& folder) {
  const auto [entry, is_new] = files_.try_emplace(folder);
  if (is_new) entry->second = BatchFile::read(root_ / folder / "batch.json", messages_, valid_);
  return entry->second;
}

}  // namespace trace
