#include "image/openimageio.hpp"

#include <fmt/format.h>

#include <array>
#include <new>
#include <utility>

#include "image/memory_file.hpp"
#include "image/openimageio_module.h"
#include "image/shared_object.hpp"
#include "image/size_limits.hpp"

namespace trace {
namespace {

constexpr const char* module_name = "trace_openimageio.so";
constexpr const char* package_name = TRACE_OPENIMAGEIO_PACKAGE;

SharedObject load_module(std::string_view task, const ModulePlaces& places) {
  for (const std::filesystem::path& place : places) {
    std::error_code ignored;
    if (!std::filesystem::exists(place, ignored)) continue;
    if (SharedObject module = load_shared_object(place.c_str())) return module;
    const std::string reason = dlerror();
    if (reason.find("cannot open shared object file") != std::string::npos)
      throw ImageError(fmt::format("{} needs OpenImageIO: install the package {}", task, package_name));
    throw ImageError(fmt::format("{} needs OpenImageIO, which cannot be loaded: {}", task, reason));
  }
  throw ImageError(fmt::format("{} needs OpenImageIO: install the package {}, and {} beside the program",
                               task, package_name, module_name));
}

template <typename Function>
Function function_of(const SharedObject& module, const char* name) {
  if (const auto function = find_function<Function>(module, name)) return function;
  throw ImageError(fmt::format("{} is of another version than the program", module_name));
}

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

ModulePlaces openimageio_places() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return {};
  const std::filesystem::path directory = program.parent_path();
  return {directory / module_name, directory.parent_path() / "lib" / "trace" / module_name};
}

Image read_with_openimageio(const std::filesystem::path& file, std::string_view format,
                            const ModulePlaces& places) {
  const SharedObject module = load_module(fmt::format("reading {}", format), places);
  const auto read = function_of<TraceReadPicture>(module, TRACE_READ_PICTURE);
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
  const SharedObject module = load_module(fmt::format("writing {}", format), places);
  const auto write = function_of<TraceWritePicture>(module, TRACE_WRITE_PICTURE);
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

#ifdef __SANITIZE_ADDRESS__
// With OpenImageIO's 261 libraries and their threads in the process, LeakSanitizer itself crashes at the end
// now and then ("Tracer caught signal 11"). It asks here whether to look for leaks: only where the module was
// not loaded.
extern "C" int __lsan_is_turned_off() {
  for (const std::filesystem::path& place : trace::openimageio_places()) {
    if (trace::SharedObject(dlopen(place.c_str(), RTLD_LAZY | RTLD_NOLOAD))) return 1;
  }
  return 0;
}
#endif
