// The batch.json files (batch_file.hpp) of a folder of scenes and of the folders below it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "batch/batch_file.hpp"

namespace trace {

class BatchFiles {
 public:
  // They are read when a scene of theirs is asked for; what is wrong is added to `messages`, which must
  // outlive this.
  BatchFiles(std::filesystem::path root, std::string& messages)
      : root_(std::move(root)), messages_(messages) {}

  // Whether none of those read so far has errors.
  bool valid() const { return valid_; }

  // What they say of a scene, by its path from the folder; nothing where one of them excludes it.
  std::optional<SceneOptions> of(const std::string& scene);

 private:
  const std::optional<BatchFile>& in(const std::filesystem::path& folder);

  std::filesystem::path root_;
  std::string& messages_;
  bool valid_ = true;
  std::map<std::filesystem::path, std::optional<BatchFile>> files_;
};

}  // namespace trace
