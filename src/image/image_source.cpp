#include "image/image_source.hpp"

#include <algorithm>

namespace trace {

std::vector<std::filesystem::path> ImageSource::list(const std::filesystem::path& folder,
                                                     std::error_code& error) {
  std::vector<std::filesystem::path> found;
  std::filesystem::directory_iterator entry(folder, error);
  for (const std::filesystem::directory_iterator end; !error && entry != end; entry.increment(error))
    found.push_back(entry->path());
  std::sort(found.begin(), found.end());
  return found;
}

SharedImage FileImages::read(const std::filesystem::path& file) {
  return share(read_image(file));
}

bool FileImages::exists(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

SharedImage share(Image image) {
  const auto owner = std::make_shared<const Image>(std::move(image));
  return {owner->width, owner->height, {owner, owner->rgb.data()}};
}

}  // namespace trace
