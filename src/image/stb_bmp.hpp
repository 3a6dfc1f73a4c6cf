// The two functions we use of the stb libraries, whose code stays in stb_bmp.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/image.hpp"

namespace trace {

// A whole BMP file as RGB. stb trusts palettes and lengths: give it only what bmp.cpp has checked.
// Throws ImageError.
Image stb_decode_bmp(std::span<const std::uint8_t> file);

// A whole BMP file, 24 bits a pixel.
std::vector<std::uint8_t> stb_encode_bmp(const Image& image);

}  // namespace trace
