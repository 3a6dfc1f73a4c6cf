// Maps of a material at a point.
#pragma once

#include <vector>

#include "scene/material.hpp"
#include "scene/texture.hpp"

namespace trace {

// The values at one point of a surface. Surfaces without texture coordinates show the lower left texel of a
// map everywhere: their uv is (0, 0).
Material at_point(const MappedMaterial& material, const std::vector<Texture>& textures, const Vec2& uv);

}  // namespace trace
