// Where the files are that a scene names.
#pragma once

#include <filesystem>
#include <string>

#include "image/image_source.hpp"

namespace trace {

class SceneFiles {
 public:
  SceneFiles(std::filesystem::path scene_folder, ImageSource& images)
      : folder_(std::move(scene_folder)), images_(images) {}

  const std::filesystem::path& folder() const { return folder_; }

  // Beside the scene, as it is written; a name with '\\' that is not there is one with '/' for each. With
  // `or_working_folder` in the working folder if it is not beside the scene. The path need not exist.
  std::filesystem::path find(const std::string& name, bool or_working_folder = false) const;

  // The same for names that were written for another place, as those of some HKUST projects, which are
  // relative to the folder that their program was started in, or absolute and of Windows: if it is not there,
  // without its leading folders, one more each time: of "./a/b/c.bmp" a/b/c.bmp, b/c.bmp and c.bmp.
  std::filesystem::path find_somewhere(const std::string& name) const;

 private:
  std::filesystem::path folder_;
  ImageSource& images_;
};

}  // namespace trace
