#include "loading/description_bytes.hpp"

namespace trace {
namespace {

template <class T>
std::size_t bytes_in(const std::vector<T>& list) {
  return list.size() * sizeof(T);
}

}  // namespace

std::size_t bytes_of(const parser::Scene& description) {
  std::size_t sum =
      bytes_in(description.items) + bytes_in(description.elements) + bytes_in(description.meshes);
  for (const parser::Mesh& mesh : description.meshes) {
    sum += bytes_in(mesh.points) + bytes_in(mesh.normals) + bytes_in(mesh.corners) +
           bytes_in(mesh.face_sizes) + bytes_in(mesh.vertex_materials.materials) +
           bytes_in(mesh.vertex_materials.of) + bytes_in(mesh.point_lists) + bytes_in(mesh.normal_lists) +
           bytes_in(mesh.face_lists) + bytes_in(mesh.material_lists);
  }
  return sum;
}

}  // namespace trace
