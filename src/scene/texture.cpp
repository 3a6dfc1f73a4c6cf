#include "scene/texture.hpp"

#include <algorithm>

#include "scene/material.hpp"

namespace trace {

struct Texture::Layer {
  Texture picture;
  double threshold;
};

Texture::Texture(const Texture& first, const Texture& second, double threshold)
    : image_(first.image_), over_(std::make_shared<const Layer>(Layer{second, threshold})) {}

void Texture::give_texels_width() {
  has_width_ = true;
  if (!over_) return;
  Layer layer = *over_;
  layer.picture.give_texels_width();
  over_ = std::make_shared<const Layer>(std::move(layer));
}

template <class T>
glm::vec<3, T, glm::defaultp> Texture::texel(int x, int y) const {
  const auto row = static_cast<std::size_t>(image_.height - 1 - y);
  const std::uint8_t* p = &image_.rgb[(row * static_cast<std::size_t>(image_.width) + x) * 3];
  return {p[0] / T(255), p[1] / T(255), p[2] / T(255)};
}

template <class T>
glm::vec<3, T, glm::defaultp> Texture::picture_at(const glm::vec<2, T, glm::defaultp>& uv) const {
  // Written so that NaN becomes 0.
  const T u = uv.x > 0 ? std::min(uv.x, T(1)) : T(0), v = uv.y > 0 ? std::min(uv.y, T(1)) : T(0);
  const T across = static_cast<T>(image_.width - 1), upward = static_cast<T>(image_.height - 1);
  const T x = has_width_ ? std::min(u * static_cast<T>(image_.width), across) : u * across;
  const T y = has_width_ ? std::min(v * static_cast<T>(image_.height), upward) : v * upward;
  const int x1 = static_cast<int>(x), y1 = static_cast<int>(y);
  const int x2 = std::min(x1 + 1, image_.width - 1), y2 = std::min(y1 + 1, image_.height - 1);
  const T s = x - static_cast<T>(x1), t = y - static_cast<T>(y1);
  return texel<T>(x1, y1) * (1 - s) * (1 - t) + texel<T>(x2, y1) * s * (1 - t) +
         texel<T>(x1, y2) * (1 - s) * t + texel<T>(x2, y2) * s * t;
}

template <class T>
glm::vec<3, T, glm::defaultp> Texture::sample_in(const glm::vec<2, T, glm::defaultp>& uv) const {
  using Color = glm::vec<3, T, glm::defaultp>;
  if (solid_) return Color(solid_->at(Vec3(0)));
  const Color first = picture_at(uv);
  if (!over_) return first;
  const Color second = over_->picture.sample_in<T>(uv);
  const T threshold = static_cast<T>(over_->threshold);
  const T weight = std::clamp((luminance(second) - threshold) / (1 - threshold), T(0), T(1));
  return (1 - weight) * first + weight * second;
}

template glm::vec<3, float, glm::defaultp> Texture::sample_in(const glm::vec<2, float, glm::defaultp>&) const;
template glm::vec<3, long double, glm::defaultp> Texture::sample_in(
    const glm::vec<2, long double, glm::defaultp>&) const;
template Rgb Texture::sample_in(const Vec2&) const;

Rgb Texture::sample(const Vec2& uv) const {
  return sample_in<double>(uv);
}

}  // namespace trace
