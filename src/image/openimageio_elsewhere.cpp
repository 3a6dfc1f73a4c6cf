// openimageio.hpp for a program that can load no module: what needs one is left to the program's other form
// (start_over.hpp).
#include <fmt/format.h>

#include "image/format.hpp"
#include "image/openimageio.hpp"
#include "image/raster_files.hpp"
#include "image/start_over.hpp"

namespace trace {
namespace {

[[noreturn]] void leave(std::string_view task, std::string_view format) {
  start_over_dynamically();
  throw ImageError(fmt::format("{} {} needs OpenImageIO: install the package {}, and {} beside the program",
                               task, format, TRACE_OPENIMAGEIO_PACKAGE, dynamic_program_name));
}

}  // namespace

ModulePlaces openimageio_places() {
  return {};
}

void settle_openimageio(const std::filesystem::path& output, std::initializer_list<std::string_view> read) {
  const auto format = format_of_extension(output.extension().string());
  if ((format && format->codec == Codec::openimageio) || !can_be_read_again(read)) start_over_dynamically();
}

void settle_openimageio() {
  start_over_dynamically();
}

Image read_with_openimageio(const std::filesystem::path&, std::string_view format, const ModulePlaces&) {
  leave("reading", format);
}

Raster read_raster_with_openimageio(const std::filesystem::path&, std::string_view format,
                                    const ModulePlaces&) {
  leave("reading", format);
}

std::vector<std::uint8_t> encode_with_openimageio(const Image&, std::string_view format, const std::string&,
                                                  const ModulePlaces&) {
  leave("writing", format);
}

}  // namespace trace
