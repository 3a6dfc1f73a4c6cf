#include "image/stb_bmp.hpp"

#include <fmt/format.h>

#include <memory>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_BMP
#define STBI_NO_STDIO
#include <stb/stb_image.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace trace {

Image stb_decode_bmp(std::span<const std::uint8_t> file) {
  Image image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> rgb(
      stbi_load_from_memory(file.data(), int(file.size()), &image.width, &image.height, &channels, 3),
      stbi_image_free);
  if (!rgb) throw ImageError(fmt::format("the BMP is damaged: {}", stbi_failure_reason()));
  image.rgb.assign(rgb.get(),
                   rgb.get() + std::size_t{3} * std::size_t(image.width) * std::size_t(image.height));
  return image;
}

std::vector<std::uint8_t> stb_encode_bmp(const Image& image) {
  std::vector<std::uint8_t> file;
  file.reserve(64 + std::size_t(image.height) * (std::size_t(image.width) * 3 + 3));
  const auto append = [](void* context, void* data, int size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    auto& to = *static_cast<std::vector<std::uint8_t>*>(context);
    to.insert(to.end(), bytes, bytes + size);
  };
  stbi_write_bmp_to_func(append, &file, image.width, image.height, 3, image.rgb.data());
  return file;
}

}  // namespace trace
