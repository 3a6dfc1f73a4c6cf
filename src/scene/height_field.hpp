// A picture of heights as a mesh.
#pragma once

#include "geometry/mesh.hpp"
#include "scene/texture.hpp"

namespace trace {

inline constexpr int most_grid_side = 2048;  // 4 million points, some 500 MB with their hierarchy

// Over the unit square of x and z the height y is the luminance of `heights`, from 0 to 1. Seen from above
// with z upward the picture is the right way round: its left edge is at x = 1, its lower edge at z = 0. A
// point a texel, the outer ones on the edges, and two triangles between four; of sides longer than
// most_grid_side so many points. Texture coordinates are those of the picture. With `smooth` normals are
// generated.
Mesh make_height_field(const Texture& heights, bool smooth);

}  // namespace trace
