#include "image/image_source.hpp"

namespace trace {

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
