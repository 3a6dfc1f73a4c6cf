#include "image/png.hpp"
#include "image/png_decoder.hpp"

namespace trace {

Image read_png(InputFile& file) {
  PngDecoder decoder(file);
  decoder.read_header();
  decoder.ask_for_rgb8();
  Image image{int(decoder.width()), int(decoder.height()), {}};
  image.rgb.resize(decoder.row_bytes() * std::size_t(image.height));
  decoder.read_pixels(image.rgb.data());
  return image;
}

}  // namespace trace
