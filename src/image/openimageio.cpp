#include "image/openimageio.hpp"

#include <fmt/format.h>

#include <array>
#include <new>
#include <utility>

#include "image/memory_file.hpp"
#include "image/openimageio_loader.hpp"
#include "image/openimageio_module.h"
#include "image/size_limits.hpp"

namespace trace {
namespace {

// Where the module's pixels go, and why there is no room for them.
struct Destination {
  Image image;
  std::string refusal;
};

unsigned char* allocate(void* context, int width, int height) noexcept {
  auto& destination = *static_cast<Destination*>(context);
  try {
    check_size(width, height);
    destination.image = {width, height, {}};
    destination.image.rgb.resize(std::size_t{3} * std::size_t(width) * std::size_t(height));
    return destination.image.rgb.data();
  } catch (const ImageError& error) {
    destination.refusal = error.what();
  } catch (const std::bad_alloc&) {
    destination.refusal = "out of memory";
  }
  return nullptr;
}

}  // namespace

void settle_openimageio(const std::filesystem::path&, std::initializer_list<std::string_view>) {}
void settle_openimageio() {}

Image read_with_openimageio(const std::filesystem::path& file, std::string_view format,
                            const ModulePlaces& places) {
  const SharedObject module = load_openimageio(fmt::format("reading {}", format), places);
  const auto read = openimageio_function<TraceReadPicture>(module, TRACE_READ_PICTURE);
  Destination destination;
  std::array<char, 512> reason{};
  if (!read(file.c_str(), allocate, &destination, reason.data(), reason.size()))
    throw ImageError(!destination.refusal.empty()
                         ? destination.refusal
                         : fmt::format("the {} cannot be read: {}", format, reason.data()));
  return std::move(destination.image);
}

std::vector<std::uint8_t> encode_with_openimageio(const Image& image, std::string_view format,
                                                  const std::string& extension, const ModulePlaces& places) {
  check_image(image);
  const SharedObject module = load_openimageio(fmt::format("writing {}", format), places);
  const auto write = openimageio_function<TraceWritePicture>(module, TRACE_WRITE_PICTURE);
  const MemoryFile file;
  std::array<char, 512> reason{};
  if (!write(file.path().c_str(), extension.c_str(), image.width, image.height, image.rgb.data(),
             reason.data(), reason.size()))
    throw ImageError(fmt::format("the {} cannot be made: {}", format, reason.data()));
  std::vector<std::uint8_t> bytes = file.bytes();
  if (bytes.empty()) throw ImageError(fmt::format("the {} cannot be made", format));
  return bytes;
}

}  // namespace trace
