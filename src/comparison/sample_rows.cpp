#include "comparison/sample_rows.hpp"

#include <algorithm>

namespace trace {
namespace {

// The nearest whole number of 0 <= value < 2^22: the sum has no bits left for a fraction.
float nearest_whole(float value) {
  constexpr float no_fraction = 0x1.8p23F;
  return (value + no_fraction) - no_fraction;
}

}  // namespace

SampleUnit common_unit(const Raster& a, const Raster& b) {
  const SampleType finer = std::max(a.type, b.type);
  if (finer == SampleType::real) return {1, false};
  return {finer == SampleType::uint16 ? 65535.0F : 255.0F, true};
}

void load_row(const Raster& raster, int y, SampleUnit unit, std::span<float> planes, std::size_t stride) {
  const float* row = raster.pixel(0, y);
  const auto channels = static_cast<std::size_t>(raster.channels);
  const auto width = static_cast<std::size_t>(raster.width);
  for (std::size_t channel = 0; channel < channels; ++channel) {
    float* plane = &planes[channel * stride];
    if (unit.whole) {
      for (std::size_t x = 0; x < width; ++x)
        plane[x] = nearest_whole(row[x * channels + channel] * unit.per_full_scale);
    } else {
      for (std::size_t x = 0; x < width; ++x) plane[x] = row[x * channels + channel];
    }
  }
}

}  // namespace trace
