// The picture while it is made: bytes, and where wanted the colours that they are cut from.
#pragma once

#include "rendering/color_image.hpp"
#include "rendering/pixel.hpp"

namespace trace {

class Film {
 public:
  Film(Image image, bool keep_colors) : image_(std::move(image)) {
    if (keep_colors) colors_ = ColorImage(image_.width, image_.height);
  }
  Film(int width, int height, bool keep_colors) : Film(black(width, height), keep_colors) {}

  // Pixels by column and row counted from the bottom. Different pixels may be set by different threads.
  void set(int i, int j, const Rgb& color) {
    set_pixel(image_, i, j, color);
    if (keeps_colors()) colors_.set(i, image_.height - 1 - j, clamped(color));
  }

  bool keeps_colors() const { return colors_.width() != 0; }
  Image& image() { return image_; }
  const Image& image() const { return image_; }
  ColorImage& colors() { return colors_; }

 private:
  static Image black(int width, int height) {
    Image image{width, height, {}};
    image.rgb.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    return image;
  }

  Image image_;
  ColorImage colors_;
};

}  // namespace trace
