#include "scene/material_maps.hpp"

namespace trace {
namespace {

// `sample(texture)` is the value of a map.
template <class T, class Sample>
BasicMaterial<T> with_maps(const BasicMappedMaterial<T>& material, const Sample& sample) {
  BasicMaterial<T> result = material.values;
  const auto take = [&](glm::vec<3, T, glm::defaultp>& value, TextureId map) {
    if (map >= 0) value = sample(static_cast<std::size_t>(map));
  };
  take(result.emissive, material.emissive);
  take(result.ambient, material.ambient);
  take(result.diffuse, material.diffuse);
  take(result.specular, material.specular);
  take(result.index, material.index);
  if (material.shininess >= 0) {
    take(result.shininess, material.shininess);
    result.shininess *= T(128);  // a map holds 0 to 1, shininess runs to 128
  }
  return result;
}

}  // namespace

template <class T>
BasicMaterial<T> at_point(const BasicMappedMaterial<T>& material, const std::vector<Texture>& textures,
                          const glm::vec<2, T, glm::defaultp>& uv) {
  return with_maps(material, [&](std::size_t map) { return textures[map].sample_in<T>(uv); });
}

template BasicMaterial<float> at_point(const BasicMappedMaterial<float>&, const std::vector<Texture>&,
                                       const glm::vec<2, float, glm::defaultp>&);
template Material at_point(const MappedMaterial&, const std::vector<Texture>&, const Vec2&);
template BasicMaterial<long double> at_point(const BasicMappedMaterial<long double>&,
                                             const std::vector<Texture>&,
                                             const glm::vec<2, long double, glm::defaultp>&);

Material at_point(const MappedMaterial& material, const std::vector<Texture>& textures, const Vec2& uv,
                  const Vec3& point) {
  return with_maps(material, [&](std::size_t map) { return textures[map].sample(uv, point); });
}

bool has_solid_maps(const MappedMaterial& material, const std::vector<Texture>& textures) {
  for (const TextureId map : {material.emissive, material.ambient, material.diffuse, material.specular,
                              material.index, material.shininess}) {
    if (map >= 0 && textures[static_cast<std::size_t>(map)].is_solid()) return true;
  }
  return false;
}

MappedMaterial without_pictures(const MappedMaterial& material, const std::vector<Texture>& textures) {
  const Material flat = at_point(material, textures, Vec2(0));
  MappedMaterial result = material;
  const auto replace = [&](Rgb& value, TextureId& map, const Rgb& constant) {
    if (map < 0 || textures[static_cast<std::size_t>(map)].is_solid()) return;
    value = constant;
    map = no_texture;
  };
  replace(result.values.emissive, result.emissive, flat.emissive);
  replace(result.values.ambient, result.ambient, flat.ambient);
  replace(result.values.diffuse, result.diffuse, flat.diffuse);
  replace(result.values.specular, result.specular, flat.specular);
  replace(result.values.index, result.index, flat.index);
  replace(result.values.shininess, result.shininess, flat.shininess);
  return result;
}

}  // namespace trace
