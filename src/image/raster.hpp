// Pictures with all the precision they were stored with: for measuring, where image.hpp is for textures and
// results.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include "image/image.hpp"

namespace trace {

enum class SampleType { uint8, uint16, real };  // `real`: any floating-point or wider type

struct Raster {
  int width = 0;
  int height = 0;
  int channels = 0;  // 1 gray, 2 gray and alpha, 3 RGB, 4 RGBA; more as the file has them
  SampleType type = SampleType::uint8;
  // Interleaved, rows from top to bottom, width * height * channels of them. Integers are scaled so that
  // their largest is 1; floating-point values are as in the file, which may be outside [0, 1], NaN or
  // infinite.
  std::vector<float> samples;

  const float* pixel(int x, int y) const {
    return &samples[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                     static_cast<std::size_t>(x)) *
                    static_cast<std::size_t>(channels)];
  }
};

// The picture in a file of any format. A palette is expanded; nothing else is converted: no gamma, no colour
// profile, alpha neither dropped nor multiplied. Throws ImageError.
Raster read_raster(const std::filesystem::path& file);

// The same of a picture in memory.
Raster to_raster(const Image& image);

}  // namespace trace
