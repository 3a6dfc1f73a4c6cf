#include "scene/material_maps.hpp"

namespace trace {

Material at_point(const MappedMaterial& material, const std::vector<Texture>& textures, const Vec2& uv) {
  Material result = material.values;
  const auto take = [&](Rgb& value, TextureId map) {
    if (map >= 0) value = textures[static_cast<std::size_t>(map)].sample(uv);
  };
  take(result.emissive, material.emissive);
  take(result.ambient, material.ambient);
  take(result.diffuse, material.diffuse);
  take(result.specular, material.specular);
  take(result.index, material.index);
  if (material.shininess >= 0) {
    take(result.shininess, material.shininess);
    result.shininess *= 128.0;  // a map holds 0 to 1, shininess runs to 128
  }
  return result;
}

}  // namespace trace
