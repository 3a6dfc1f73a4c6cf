#include "image/raster.hpp"

#include "image/bmp.hpp"
#include "image/format.hpp"
#include "image/raster_files.hpp"
#include "image/raster_samples.hpp"
#include "image/size_limits.hpp"

namespace trace {

Raster to_raster(const Image& image) {
  check_image(image);
  check_samples(image.width, image.height, 3);
  return {image.width, image.height, 3, SampleType::uint8, samples_of_bytes(image.rgb)};
}

Raster read_raster(const std::filesystem::path& path) {
  InputFile file(path);
  const auto format = format_of_content(file.first(magic_length), path.extension().string());
  if (!format) throw ImageError("not a picture this program can read");
  switch (format->codec) {
    case Codec::png:
      return read_png_raster(file);
    case Codec::bmp:
      return to_raster(read_bmp(file));
    case Codec::openimageio:
      break;
  }
  return read_raster_with_openimageio(path, format->name);
}

}  // namespace trace
