// `batch.json`: options for scenes in its folder and below.
//
//   { "default": { "depth": 3, "settings": { "anti_alias": true } },
//     "scenes": { "glass/*": { "depth": 10 }, "sky.ray": { "cubemap": "sky/posx.png" } },
//     "exclude": ["draft*"] }
//
// Patterns are those of scene_list.hpp, on paths from that folder. "default" comes first, then whatever
// matches, in the order of the file; what is said later wins, and so does the file of a deeper folder. All of
// it wins over the command line. Files are named from that folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "loading/settings_file.hpp"

namespace trace {

// What can be said of a scene. As in the command line's order, `settings` is applied after depth and width.
struct SceneOptions {
  std::optional<int> depth, width;
  std::optional<std::string> cube_map;  // one of its faces
  std::optional<double> timeout;        // seconds
  std::optional<double> memory;         // MiB
  std::vector<Settings> settings;

  // What `other` gives replaces what is here.
  void add(const SceneOptions& other);
};

class BatchFile {
 public:
  // Nothing where there is no such file. What is wrong is added to `messages`; `valid` becomes false for
  // errors.
  static std::optional<BatchFile> read(const std::filesystem::path& file, std::string& messages, bool& valid);

  // What the file says of a scene, by its path from the file's folder.
  SceneOptions of(const std::string& scene) const;
  const std::vector<std::string>& exclude() const { return exclude_; }

 private:
  struct Reader;

  struct Entry {
    std::string pattern;
    SceneOptions options;
  };
  std::vector<Entry> entries_;
  std::vector<std::string> exclude_;
};

}  // namespace trace
