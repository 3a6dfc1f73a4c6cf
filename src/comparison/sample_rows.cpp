#include "comparison/sample_rows.hpp"

#include <algorithm>

#include "comparison/vector_clones.hpp"

namespace trace {
namespace {

// The nearest whole number of 0 <= value < 2^22: the sum has no bits left for a fraction.
float nearest_whole(float value) {
  constexpr float no_fraction = 0x1.8p23F;
  return (value + no_fraction) - no_fraction;
}

TRACE_VECTOR_CLONES void load_whole_rgb(const float* __restrict row, std::size_t width, float per_full_scale,
                                        float* __restrict r, float* __restrict g, float* __restrict b) {
  for (std::size_t x = 0; x < width; ++x) {
    r[x] = nearest_whole(row[3 * x] * per_full_scale);
    g[x] = nearest_whole(row[3 * x + 1] * per_full_scale);
    b[x] = nearest_whole(row[3 * x + 2] * per_full_scale);
  }
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
  if (unit.whole && channels == 3) {  // the usual
    load_whole_rgb(row, width, unit.per_full_scale, planes.data(), &planes[stride], &planes[2 * stride]);
    return;
  }
  for (std::size_t channel = 0; channel < channels; ++channel) {
    float* plane = &planes[channel * stride];
    for (std::size_t x = 0; x < width; ++x) {
      const float sample = row[x * channels + channel];
      plane[x] = unit.whole ? nearest_whole(sample * unit.per_full_scale) : sample;
    }
  }
}

}  // namespace trace
