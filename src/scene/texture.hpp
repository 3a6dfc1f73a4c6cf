// What stands for a material parameter in place of a number: a picture, or a pattern in space.
#pragma once

#include <memory>

#include "geometry/vector.hpp"
#include "image/image_source.hpp"
#include "scene/solid_pattern.hpp"

namespace trace {

class Texture {
 public:
  explicit Texture(SharedImage image) : image_(std::move(image)) {}
  explicit Texture(Image image) : Texture(share(std::move(image))) {}
  // `first` with `second` laid over it where that is bright: with w = (luminance of the second - threshold) /
  // (1 - threshold), limited to [0, 1], each colour is (1 - w) first + w second. `threshold` is less than 1.
  Texture(const Texture& first, const Texture& second, double threshold);
  // Its value depends on the point of space alone.
  explicit Texture(const SolidPattern& pattern) : solid_(std::make_shared<const SolidPattern>(pattern)) {}

  // Bilinear value at (u, v) in [0, 1]^2 (clamped), v upward: x = u (w-1), y = v (h-1) between the centres of
  // the four texels around it; texel = byte / 255. Terms are summed left to right, each colour * x weight * y
  // weight.
  Rgb sample(const Vec2& uv) const;
  // The value at a place of a picture, or at a point of a pattern.
  Rgb sample(const Vec2& uv, const Vec3& point) const { return solid_ ? solid_->at(point) : sample(uv); }
  bool is_solid() const { return solid_ != nullptr; }
  // From here on u = 1 is the far edge of the last texel, not its centre: x = u w and y = v h, and what lies
  // beyond the last texel is that texel.
  void give_texels_width();
  // The same in another kind of number: float, double or long double.
  template <class T>
  glm::vec<3, T, glm::defaultp> sample_in(const glm::vec<2, T, glm::defaultp>& uv) const;

  int width() const { return image_.width; }
  int height() const { return image_.height; }

 private:
  template <class T>
  glm::vec<3, T, glm::defaultp> texel(int x, int y) const;  // y = 0 is the bottom row
  template <class T>
  glm::vec<3, T, glm::defaultp> picture_at(const glm::vec<2, T, glm::defaultp>& uv) const;

  SharedImage image_;
  struct Layer;
  std::shared_ptr<const Layer> over_;
  std::shared_ptr<const SolidPattern> solid_;
  bool has_width_ = false;
};

}  // namespace trace
