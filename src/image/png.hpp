// PNG: read by libpng, written with zlib.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.hpp"
#include "image/input_file.hpp"

namespace trace {

// Every kind of PNG as 8-bit RGB: palette and gray expanded, 16 bits cut to the high byte, alpha and tRNS
// dropped. If the file has a gAMA chunk with value g, a channel c in [0, 1] becomes c^(1 / (2.2 g)), which
// libpng leaves out where |2.2 g - 1| < .05. Other colour information (sRGB, iCCP, cHRM) is not heeded.
// Throws ImageError for a damaged file, or one that ends too early.
Image read_png(InputFile& file);

// The bytes of a PNG file: 8-bit RGB, not interlaced, neither gAMA nor a time, the same for the same picture
// whatever the number of threads. Throws ImageError.
std::vector<std::uint8_t> encode_png(const Image& image, int threads = 1);

}  // namespace trace
