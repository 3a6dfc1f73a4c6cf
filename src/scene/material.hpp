// What a surface is made of.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/vector.hpp"

namespace trace {

// 0.299 r + 0.587 g + 0.114 b. Numbers of a material are kept as grey triples and read through this, as the
// course's renderer does: the weights do not sum to one in binary, which shows in the last bit.
inline double luminance(const Rgb& c) {
  return 0.299 * c.x + 0.587 * c.y + 0.114 * c.z;
}

// Values at one point of a surface. Everything is zero unless said; the index of refraction is one.
struct Material {
  Rgb emissive{0}, ambient{0}, diffuse{0}, specular{0}, reflective{0}, transmissive{0};
  Rgb index{1}, shininess{0};

  bool reflects() const { return !is_zero(reflective); }
  bool transmits() const { return !is_zero(transmissive); }
};

// Linear in every parameter; what reflects and transmits is then decided on the mixed values.
inline Material mix(const Material& a, const Material& b, const Material& c, double wa, double wb,
                    double wc) {
  const auto sum = [&](const Rgb& x, const Rgb& y, const Rgb& z) { return wa * x + wb * y + wc * z; };
  return {sum(a.emissive, b.emissive, c.emissive),
          sum(a.ambient, b.ambient, c.ambient),
          sum(a.diffuse, b.diffuse, c.diffuse),
          sum(a.specular, b.specular, c.specular),
          sum(a.reflective, b.reflective, c.reflective),
          sum(a.transmissive, b.transmissive, c.transmissive),
          sum(a.index, b.index, c.index),
          sum(a.shininess, b.shininess, c.shininess)};
}

using TextureId = std::int32_t;
inline constexpr TextureId no_texture = -1;

// A material whose parameters may be maps. A map for `reflective` or `transmissive` is left out: the surface
// neither mirrors nor lets light through (docs/language.md section 6).
struct MappedMaterial {
  Material values;
  TextureId emissive = no_texture, ambient = no_texture, diffuse = no_texture, specular = no_texture;
  TextureId index = no_texture, shininess = no_texture;

  bool has_maps() const {
    return emissive >= 0 || ambient >= 0 || diffuse >= 0 || specular >= 0 || index >= 0 || shininess >= 0;
  }
};

}  // namespace trace
