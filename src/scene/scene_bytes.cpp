#include "scene/scene_bytes.hpp"

namespace trace {
namespace {

template <class T>
std::size_t bytes_in(const std::vector<T>& list) {
  return list.size() * sizeof(T);
}

std::size_t pixel_bytes(const std::vector<Texture>& textures) {
  std::size_t sum = 0;
  for (const Texture& texture : textures)
    sum += std::size_t{3} * static_cast<std::size_t>(texture.width()) *
           static_cast<std::size_t>(texture.height());
  return sum;
}

}  // namespace

SceneBytes bytes_of(const Scene& scene) {
  SceneBytes result;
  for (const SceneMesh& mesh : scene.meshes) {
    result.meshes += sizeof mesh + bytes_in(mesh.geometry.points) + bytes_in(mesh.geometry.normals) +
                     bytes_in(mesh.geometry.faces) + bytes_in(mesh.geometry.coordinates) +
                     bytes_in(mesh.materials);
  }
  result.textures = pixel_bytes(scene.textures);
  if (scene.cube_map) result.textures += pixel_bytes(scene.cube_map->faces());
  result.rest =
      bytes_in(scene.objects) + bytes_in(scene.frames) + bytes_in(scene.materials) + bytes_in(scene.lights);
  return result;
}

}  // namespace trace
