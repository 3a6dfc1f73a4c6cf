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

}  // namespace trace
