// How large a picture may be. The limits keep a damaged or hostile file from exhausting the memory: the
// largest picture takes 768 MiB.
#pragma once

#include <cstdint>

#include "image/image.hpp"

namespace trace {

inline constexpr std::int64_t max_side = 65536;  // pixels
inline constexpr std::int64_t max_pixels = std::int64_t{1} << 28;
inline constexpr int max_channels = 16;                             // of a picture to be measured, whose
inline constexpr std::int64_t max_samples = std::int64_t{1} << 28;  // samples take 4 bytes: at most 1 GiB

// Throws ImageError unless 1 <= width, height <= max_side and width * height <= max_pixels.
void check_size(std::int64_t width, std::int64_t height);

// Throws ImageError unless, further, 1 <= channels <= max_channels and there are at most max_samples.
void check_samples(std::int64_t width, std::int64_t height, int channels);

// Throws ImageError unless the size is allowed and `rgb` holds exactly its pixels.
void check_image(const Image& image);

}  // namespace trace
