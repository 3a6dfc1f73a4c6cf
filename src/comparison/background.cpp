#include "comparison/background.hpp"

#include <algorithm>

namespace trace {
namespace {

template <typename Visit>
void for_border(const Raster& raster, Visit visit) {
  for (int x = 0; x < raster.width; ++x) {
    visit(raster.pixel(x, 0));
    if (raster.height > 1) visit(raster.pixel(x, raster.height - 1));
  }
  for (int y = 1; y < raster.height - 1; ++y) {
    visit(raster.pixel(0, y));
    if (raster.width > 1) visit(raster.pixel(raster.width - 1, y));
  }
}

}  // namespace

std::vector<float> background_of(const Raster& reference) {
  const auto channels = static_cast<std::size_t>(reference.channels);
  const auto equal = [channels](const float* a, const float* b) { return std::equal(a, a + channels, b); };
  // The only colour that can have the majority (Boyer and Moore 1981), then its count.
  const float* candidate = nullptr;
  std::size_t lead = 0;
  for_border(reference, [&](const float* pixel) {
    if (lead == 0) candidate = pixel;
    lead += candidate == pixel || equal(candidate, pixel) ? 1 : std::size_t(-1);
  });
  std::size_t count = 0, border = 0;
  for_border(reference, [&](const float* pixel) {
    ++border;
    count += equal(candidate, pixel);
  });
  if (2 * count > border) return {candidate, candidate + channels};
  return std::vector<float>(channels, 0.0F);
}

}  // namespace trace
