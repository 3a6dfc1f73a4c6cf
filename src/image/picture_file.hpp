// A place for a picture, found writable before the picture is made.
#pragma once

#include <filesystem>
#include <optional>

#include "image/atomic_file.hpp"
#include "image/format.hpp"
#include "image/image.hpp"

namespace trace {

class PictureFile {
 public:
  // Throws what write_image() would for this name: an unknown type, a folder that is not there. Nothing is
  // seen of it until write(): a file that has no name yet is kept open, any other is closed again.
  explicit PictureFile(const std::filesystem::path& path);

  // As write_image(); once.
  void write(const Image& image, int threads = 1);

 private:
  std::filesystem::path path_;
  Format format_;
  std::optional<AtomicFile> file_;
};

}  // namespace trace
