// Pictures that stand for a material parameter.
#pragma once

#include "geometry/vector.hpp"
#include "image/image_source.hpp"

namespace trace {

class Texture {
 public:
  explicit Texture(SharedImage image) : image_(std::move(image)) {}
  explicit Texture(Image image) : Texture(share(std::move(image))) {}

  // Bilinear value at (u, v) in [0, 1]^2 (clamped), v upward: x = u (w-1), y = v (h-1) between the centres of
  // the four texels around it; texel = byte / 255. Terms are summed left to right, each colour * x weight * y
  // weight.
  Rgb sample(const Vec2& uv) const;
  // The same in another kind of number: float, double or long double.
  template <class T>
  glm::vec<3, T, glm::defaultp> sample_in(const glm::vec<2, T, glm::defaultp>& uv) const;

  int width() const { return image_.width; }
  int height() const { return image_.height; }

 private:
  template <class T>
  glm::vec<3, T, glm::defaultp> texel(int x, int y) const;  // y = 0 is the bottom row

  SharedImage image_;
};

}  // namespace trace
