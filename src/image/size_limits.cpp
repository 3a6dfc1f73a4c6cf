#include "image/size_limits.hpp"

#include <fmt/format.h>

namespace trace {

void check_size(std::int64_t width, std::int64_t height) {
  if (width < 1 || height < 1)
    throw ImageError(fmt::format("a picture of {} x {} pixels holds nothing", width, height));
  if (width > max_side || height > max_side)
    throw ImageError(
        fmt::format("{} x {} pixels are too many: a side may have at most {}", width, height, max_side));
  if (width * height > max_pixels)
    throw ImageError(
        fmt::format("{} x {} pixels are too many: a picture may have at most {}", width, height, max_pixels));
}

void check_samples(std::int64_t width, std::int64_t height, int channels) {
  check_size(width, height);
  if (channels < 1 || channels > max_channels)
    throw ImageError(fmt::format("{} channels are not between 1 and {}", channels, max_channels));
  if (width * height * channels > max_samples)
    throw ImageError(fmt::format("{} x {} pixels of {} channels are too many to measure: at most {} samples",
                                 width, height, channels, max_samples));
}

void check_image(const Image& image) {
  check_size(image.width, image.height);
  const std::size_t expected = std::size_t{3} * std::size_t(image.width) * std::size_t(image.height);
  if (image.rgb.size() != expected)
    throw ImageError(fmt::format("a picture of {} x {} pixels needs {} bytes, not {}", image.width,
                                 image.height, expected, image.rgb.size()));
}

}  // namespace trace
