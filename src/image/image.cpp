#include "image/image.hpp"

#include "image/bmp.hpp"
#include "image/format.hpp"
#include "image/input_file.hpp"
#include "image/openimageio.hpp"
#include "image/png.hpp"

namespace trace {

DecodedImage decode_image(const std::filesystem::path& path) {
  InputFile file(path);
  const auto format = format_of_content(file.first(magic_length), path.extension().string());
  if (!format) throw ImageError("not a picture this program can read");
  switch (format->codec) {
    case Codec::png:
      return {read_png(file), Codec::png, file.size()};
    case Codec::bmp:
      return {read_bmp(file), Codec::bmp, file.size()};
    case Codec::openimageio:
      break;
  }
  return {read_with_openimageio(path, format->name), Codec::openimageio, file.size()};
}

Image read_image(const std::filesystem::path& path) {
  return decode_image(path).image;
}

}  // namespace trace
