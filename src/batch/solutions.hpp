// The solution pictures of a folder, by the names of their scenes.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace trace {

class Solutions {
 public:
  explicit Solutions(std::filesystem::path root) : root_(std::move(root)) {}

  // The picture with the name of a scene (its path below the folder of scenes) but for the extension. Empty
  // where there is none. Of several kinds of picture .png comes first, then .bmp, then others.
  std::filesystem::path find(const std::string& scene);

 private:
  std::filesystem::path root_;
  std::map<std::filesystem::path, std::vector<std::filesystem::path>> files_;
};

}  // namespace trace
