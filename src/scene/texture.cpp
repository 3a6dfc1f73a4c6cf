#include "scene/texture.hpp"

#include <algorithm>

namespace trace {

Rgb Texture::texel(int x, int y) const {
  const auto row = static_cast<std::size_t>(image_.height - 1 - y);
  const std::uint8_t* p = &image_.rgb[(row * static_cast<std::size_t>(image_.width) + x) * 3];
  return Rgb(p[0] / 255.0, p[1] / 255.0, p[2] / 255.0);
}

Rgb Texture::sample(const Vec2& uv) const {
  // Written so that NaN becomes 0.
  const double u = uv.x > 0 ? std::min(uv.x, 1.0) : 0.0, v = uv.y > 0 ? std::min(uv.y, 1.0) : 0.0;
  const double x = u * (image_.width - 1), y = v * (image_.height - 1);
  const int x1 = static_cast<int>(x), y1 = static_cast<int>(y);
  const int x2 = std::min(x1 + 1, image_.width - 1), y2 = std::min(y1 + 1, image_.height - 1);
  const double s = x - x1, t = y - y1;
  return texel(x1, y1) * (1 - s) * (1 - t) + texel(x2, y1) * s * (1 - t) + texel(x1, y2) * (1 - s) * t +
         texel(x2, y2) * s * t;
}

}  // namespace trace
