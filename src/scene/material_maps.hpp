// Maps of a material at a point.
#pragma once

#include <vector>

#include "scene/material.hpp"
#include "scene/texture.hpp"

namespace trace {

// The values at one point of a surface. Surfaces without texture coordinates show the lower left texel of a
// map everywhere: their uv is (0, 0). T is float, double or long double.
template <class T>
BasicMaterial<T> at_point(const BasicMappedMaterial<T>& material, const std::vector<Texture>& textures,
                          const glm::vec<2, T, glm::defaultp>& uv);

// The same where textures may be patterns in space; `point` is in the object's own.
Material at_point(const MappedMaterial& material, const std::vector<Texture>& textures, const Vec2& uv,
                  const Vec3& point);

// Whether any parameter is a pattern in space.
bool has_solid_maps(const MappedMaterial& material, const std::vector<Texture>& textures);

// The material without its pictures: each is its value at (0, 0). Patterns stay.
MappedMaterial without_pictures(const MappedMaterial& material, const std::vector<Texture>& textures);

}  // namespace trace
