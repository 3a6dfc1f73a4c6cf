#include "scene/height_field.hpp"

#include <algorithm>

#include "scene/material.hpp"

namespace trace {

Mesh make_height_field(const Texture& heights, bool smooth) {
  const int columns = std::clamp(heights.width(), 2, most_grid_side);
  const int rows = std::clamp(heights.height(), 2, most_grid_side);
  Mesh mesh;
  const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  mesh.points.reserve(count);
  mesh.coordinates.reserve(count);
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const Vec2 uv(static_cast<double>(i) / (columns - 1), static_cast<double>(j) / (rows - 1));
      mesh.points.emplace_back(1 - uv.x, luminance(heights.sample(uv)), uv.y);
      mesh.coordinates.push_back(uv);
    }
  }
  mesh.faces.reserve(2 * (count - static_cast<std::size_t>(columns + rows) + 1));
  for (int j = 0; j + 1 < rows; ++j) {
    for (int i = 0; i + 1 < columns; ++i) {
      const auto here = static_cast<std::uint32_t>(j * columns + i);
      const auto above = here + static_cast<std::uint32_t>(columns);
      // Facing upward: x falls with i.
      mesh.faces.push_back({here, here + 1, above + 1});
      mesh.faces.push_back({here, above + 1, above});
    }
  }
  if (smooth) generate_normals(mesh);
  return mesh;
}

}  // namespace trace
