#include "scene/make_mesh.hpp"

namespace trace {
namespace {

// Leaves `numbers` without memory.
std::vector<Vec3> take_vectors(std::vector<double>& numbers) {
  std::vector<Vec3> result;
  result.reserve(numbers.size() / 3);
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    result.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  std::vector<double>().swap(numbers);
  return result;
}

}  // namespace

Mesh make_mesh(parser::Mesh said, bool unit_normals) {
  Mesh mesh;
  mesh.points = take_vectors(said.points);
  mesh.normals = take_vectors(said.normals);
  mesh.coordinates.reserve(said.texture_coordinates.size() / 2);
  for (std::size_t i = 0; i + 1 < said.texture_coordinates.size(); i += 2) {
    mesh.coordinates.emplace_back(said.texture_coordinates[i], said.texture_coordinates[i + 1]);
  }
  std::vector<double>().swap(said.texture_coordinates);
  const bool triangles = said.face_sizes.empty();
  const std::size_t count = triangles ? said.corners.size() / 3 : said.face_sizes.size();
  mesh.faces.reserve(said.corners.size() - 2 * count);
  std::size_t first = 0;
  for (std::size_t face = 0; face < count; ++face) {
    const std::uint32_t size = triangles ? 3 : said.face_sizes[face];
    add_polygon(mesh, &said.corners[first], size);
    first += size;
  }
  if (said.generate_normals) {
    generate_normals(mesh);
    if (unit_normals) normalize_normals(mesh);
  }
  return mesh;
}

}  // namespace trace
