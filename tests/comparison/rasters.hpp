// Small pictures for the tests of measuring.
#pragma once

#include <functional>
#include <random>

#include "image/raster.hpp"

namespace trace::test {

// 8-bit samples from levels, interleaved.
inline Raster levels(int width, int height, int channels, const std::vector<int>& values) {
  Raster raster{width, height, channels, SampleType::uint8, {}};
  for (const int value : values) raster.samples.push_back(static_cast<float>(value) / 255);
  return raster;
}

// All samples of one level.
inline Raster uniform(int width, int height, int channels, int level) {
  return levels(width, height, channels,
                std::vector<int>(static_cast<std::size_t>(width * height * channels), level));
}

// 8-bit RGB, each pixel from its place.
inline Raster drawn(int width, int height, const std::function<std::array<int, 3>(int, int)>& color) {
  std::vector<int> values;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int level : color(x, y)) values.push_back(level);
  return levels(width, height, 3, values);
}

inline Raster floats(int width, int height, int channels, std::vector<float> samples) {
  return {width, height, channels, SampleType::real, std::move(samples)};
}

// The same on every machine.
inline Raster noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  return drawn(width, height, [&](int, int) {
    const auto one = [&] { return static_cast<int>(random() % 256); };
    const int r = one(), g = one(), b = one();
    return std::array{r, g, b};
  });
}

inline void set(Raster& raster, int x, int y, int channel, int level) {
  raster.samples[static_cast<std::size_t>((y * raster.width + x) * raster.channels + channel)] =
      static_cast<float>(level) / 255;
}

}  // namespace trace::test
