#include "batch/solutions.hpp"

#include <cctype>
#include <string_view>

#include "image/image_source.hpp"

namespace trace {

std::filesystem::path Solutions::find(const std::string& scene) {
  const std::filesystem::path name = (root_ / scene).replace_extension("");
  const std::filesystem::path folder = name.parent_path();
  auto entry = files_.find(folder);
  if (entry == files_.end()) {
    std::error_code ignored;
    entry = files_.emplace(folder, FileImages().list(folder, ignored)).first;
  }
  for (const std::string_view wanted :
       {".png", ".bmp", ".exr", ".tif", ".tiff", ".jpg", ".jpeg", ".tga", ".ppm", ".gif", ".hdr"}) {
    for (const std::filesystem::path& file : entry->second) {
      std::string extension = file.extension().string();
      for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      if (extension == wanted && file.stem() == name.filename()) return file;
    }
  }
  return {};
}

}  // namespace trace
