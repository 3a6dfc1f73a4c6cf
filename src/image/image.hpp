// Pictures as files: reading textures, writing results.
//
// What is in a picture is told by its first bytes when reading and by the name's extension when writing.
// PNG is read by libpng and written with zlib, BMP goes through stb; every other format through OpenImageIO,
// which is loaded only when a file needs it (openimageio.hpp).
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "image/format.hpp"

namespace trace {

// 8-bit RGB picture: 3 bytes a pixel, rows from top to bottom.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

// Why a picture could not be read or written. The text is the reason alone, without the file's name:
// "no such file", "not a picture this program can read".
struct ImageError : std::runtime_error {
  using runtime_error::runtime_error;
};

// The picture in a file of any format, as 8-bit RGB: palette and gray expanded, 16 bits cut to the high byte,
// alpha dropped. A PNG with a gAMA chunk is corrected to a screen of gamma 2.2; no other colour information
// is heeded. Throws ImageError.
Image read_image(const std::filesystem::path& path);

// The same, with who decoded it and how long the file is.
struct DecodedImage {
  Image image;
  Codec codec;
  std::uint64_t file_bytes;
};
DecodedImage decode_image(const std::filesystem::path& path);

// Writes by the extension: .png, .bmp, or any other that OpenImageIO knows. A file already there is replaced
// whole or left as it was. At most `threads` threads share the work. Throws ImageError.
void write_image(const std::filesystem::path& path, const Image& image, int threads = 1);

// Throws what write_image would for this name, without writing: an unknown type, a folder that is not there.
// For programs that would otherwise work long before they notice.
void check_writable(const std::filesystem::path& path);

}  // namespace trace
