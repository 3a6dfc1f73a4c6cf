#include "tools/benchmark/kernels/mesh_scene.hpp"

#include <stdexcept>

#include "loading/scene_loader.hpp"

namespace trace::bench {
namespace {

Vec3 chosen_light(const Scene& scene) {
  for (const Light& light : scene.lights) {
    if (const auto* point = std::get_if<PointLight>(&light)) return point->position;
  }
  Bounds all;
  for (const Object& object : scene.objects) all.add(object.bounds);
  const double diagonal = all.empty() ? 1 : glm::length(all.max - all.min);
  for (const Light& light : scene.lights) {
    if (const auto* directional = std::get_if<DirectionalLight>(&light)) {
      return 0.5 * (all.min + all.max) + 2 * diagonal * directional->towards;
    }
  }
  const Camera& camera = scene.camera;
  return camera.eye + 0.5 * diagonal * (glm::normalize(camera.right) + glm::normalize(camera.up));
}

}  // namespace

Scene read_scene(const std::string& file, int width) {
  FileImages images;
  LoadedScene loaded = load_scene(file, width, images);
  if (!loaded.scene) throw std::runtime_error(loaded.messages);
  return std::move(*loaded.scene);
}

MeshScene read_mesh_scene(const std::string& file, int width) {
  MeshScene result{read_scene(file, width)};
  std::erase_if(result.scene.objects,
                [](const Object& object) { return !std::holds_alternative<MeshId>(object.shape); });
  result.extra_light = chosen_light(result.scene);
  return result;
}

}  // namespace trace::bench
