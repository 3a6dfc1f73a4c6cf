#include "image/picture_file.hpp"

#include <fmt/format.h>

#include <string>
#include <system_error>
#include <vector>

#include "image/bmp.hpp"
#include "image/openimageio.hpp"
#include "image/png.hpp"
#include "image/size_limits.hpp"

namespace trace {
namespace {

Format output_format(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  const auto format = format_of_extension(extension);
  if (!format && extension.empty())
    throw ImageError("the name has no extension that tells the type of picture");
  if (!format) throw ImageError(fmt::format("cannot write pictures of type '{}'", extension));
  return *format;
}

std::vector<std::uint8_t> encode(const Image& image, const Format& format, const std::string& extension,
                                 int threads) {
  switch (format.codec) {
    case Codec::png:
      return encode_png(image, threads);
    case Codec::bmp:
      return encode_bmp(image);
    case Codec::openimageio:
      break;
  }
  return encode_with_openimageio(image, format.name, extension);
}

void fill(AtomicFile& file, const Image& image, const Format& format, const std::filesystem::path& path,
          int threads) {
  file.write(encode(image, format, path.extension().string(), threads));
  file.commit();
}

}  // namespace

PictureFile::PictureFile(const std::filesystem::path& path) : path_(path), format_(output_format(path)) {
  std::error_code ignored;
  if (std::filesystem::is_fifo(path, ignored)) return;  // closing it again would end it for its reader
  file_.emplace(path);
  if (!file_->is_nameless()) file_.reset();
}

void PictureFile::write(const Image& image, int threads) {
  check_image(image);
  if (!file_) file_.emplace(path_);
  fill(*file_, image, format_, path_, threads);
}

void check_writable(const std::filesystem::path& path) {
  const PictureFile probe(path);
}

void write_image(const std::filesystem::path& path, const Image& image, int threads) {
  check_image(image);
  const Format format = output_format(path);
  AtomicFile file(path);  // before the work of encoding: it may well be that nothing can be written there
  fill(file, image, format, path, threads);
}

}  // namespace trace
