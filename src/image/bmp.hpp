// BMP, by stb_image and stb_image_write.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.hpp"
#include "image/input_file.hpp"

namespace trace {

// Uncompressed BMP of 1, 4, 8, 16, 24 or 32 bits a pixel. Throws ImageError for another kind, a damaged file,
// or one that ends too early.
Image read_bmp(InputFile& file);

// The bytes of a BMP file with 24 bits a pixel.
std::vector<std::uint8_t> encode_bmp(const Image& image);

}  // namespace trace
