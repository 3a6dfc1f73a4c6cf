#include "scene/material_maps.hpp"

namespace trace {

template <class T>
BasicMaterial<T> at_point(const BasicMappedMaterial<T>& material, const std::vector<Texture>& textures,
                          const glm::vec<2, T, glm::defaultp>& uv) {
  BasicMaterial<T> result = material.values;
  const auto take = [&](glm::vec<3, T, glm::defaultp>& value, TextureId map) {
    if (map >= 0) value = textures[static_cast<std::size_t>(map)].sample_in<T>(uv);
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

template BasicMaterial<float> at_point(const BasicMappedMaterial<float>&, const std::vector<Texture>&,
                                       const glm::vec<2, float, glm::defaultp>&);
template Material at_point(const MappedMaterial&, const std::vector<Texture>&, const Vec2&);
template BasicMaterial<long double> at_point(const BasicMappedMaterial<long double>&,
                                             const std::vector<Texture>&,
                                             const glm::vec<2, long double, glm::defaultp>&);

}  // namespace trace
