// What a surface is made of.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "geometry/vector.hpp"

namespace trace {

// 0.299 r + 0.587 g + 0.114 b. Numbers of a material are kept as grey triples and read through this, as the
// course's renderer does: the weights do not sum to one in binary, which shows in the last bit.
template <class T>
T luminance(const glm::vec<3, T, glm::defaultp>& c) {
  return T(0.299) * c.x + T(0.587) * c.y + T(0.114) * c.z;
}

// Values at one point of a surface. Everything is zero unless said; the index of refraction is one. T is the
// kind of number: double in a scene, others where the arithmetic is compared (src/precision).
template <class T>
struct BasicMaterial {
  using Color = glm::vec<3, T, glm::defaultp>;
  Color emissive{0}, ambient{0}, diffuse{0}, specular{0}, reflective{0}, transmissive{0};
  Color index{1}, shininess{0};

  bool reflects() const { return !is_black(reflective); }
  bool transmits() const { return !is_black(transmissive); }

 private:
  static bool is_black(const Color& c) { return c.x == 0 && c.y == 0 && c.z == 0; }
};

using Material = BasicMaterial<double>;

// Linear in every parameter; what reflects and transmits is then decided on the mixed values.
template <class T>
BasicMaterial<T> mix(const BasicMaterial<T>& a, const BasicMaterial<T>& b, const BasicMaterial<T>& c,
                     std::type_identity_t<T> wa, std::type_identity_t<T> wb, std::type_identity_t<T> wc) {
  using Color = typename BasicMaterial<T>::Color;
  const auto sum = [&](const Color& x, const Color& y, const Color& z) { return wa * x + wb * y + wc * z; };
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
template <class T>
struct BasicMappedMaterial {
  BasicMaterial<T> values;
  TextureId emissive = no_texture, ambient = no_texture, diffuse = no_texture, specular = no_texture;
  TextureId index = no_texture, shininess = no_texture;
  bool on_any_surface = false;  // a map is written as a bare string: it has a place on curved surfaces too

  // What dialects add. They are the same all over an object, also of a mesh whose points have materials.
  Rgb absorb{0};             // light is dimmed by exp(-absorb t) on a way t inside, on top of kt^t
  double glossiness = 0;     // what is mirrored is spread: a point of a sphere of this radius is added to the
                             // mirrored direction of unit length
  bool blinn_phong = false;  // highlights by the half vector instead of the mirrored one

  bool has_extras() const { return blinn_phong || glossiness != 0 || !is_zero(absorb); }

  // Of heights and of normals (scene/surface_maps.hpp): they turn the surface, not its parameters.
  TextureId bump = no_texture, normal = no_texture;

  bool turns_normals() const { return bump >= 0 || normal >= 0; }
  bool has_maps() const {
    return emissive >= 0 || ambient >= 0 || diffuse >= 0 || specular >= 0 || index >= 0 || shininess >= 0;
  }
};

using MappedMaterial = BasicMappedMaterial<double>;

}  // namespace trace
