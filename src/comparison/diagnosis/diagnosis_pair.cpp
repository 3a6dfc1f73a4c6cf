#include "comparison/diagnosis/diagnosis_pair.hpp"

#include <cmath>

namespace trace {
namespace {

// False where a sample is not finite.
bool to_levels(const Raster& raster, Image& image) {
  image.width = raster.width;
  image.height = raster.height;
  const std::size_t pixels = static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height);
  const auto channels = static_cast<std::size_t>(raster.channels);
  image.rgb.resize(pixels * 3);
  float sum = 0;  // is NaN once a sample is not finite
  for (std::size_t i = 0; i < pixels; ++i) {
    const float* from = &raster.samples[i * channels];
    for (std::size_t c = 0; c < 3; ++c) {
      const float sample = from[channels < 3 ? 0 : c];
      sum += sample * 0.0F;
      image.rgb[i * 3 + c] =
          static_cast<std::uint8_t>(std::max(0.0F, std::min(sample, 1.0F)) * 255.0F + 0.5F);
    }
  }
  return std::isfinite(sum);
}

}  // namespace

std::optional<PicturePair> make_pair(const Raster& reference, const Raster& test) {
  if (reference.width != test.width || reference.height != test.height) return std::nullopt;
  if (reference.channels != test.channels || test.channels < 1 || test.channels > 4) return std::nullopt;
  PicturePair pair;
  pair.width = test.width;
  pair.height = test.height;
  if (!to_levels(reference, pair.reference) || !to_levels(test, pair.test)) return std::nullopt;
  const std::size_t pixels = pair.test.rgb.size() / 3;
  pair.differs.resize(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    if (distance(pair.of_reference(i), pair.of_test(i)) <= 1) continue;
    pair.differs[i] = 1;
    pair.differing.push_back(static_cast<std::uint32_t>(i));
  }
  return pair;
}

}  // namespace trace
