#include "scene/beyond_course.hpp"

#include <algorithm>

namespace trace {

namespace {

// What of an object.
std::string_view beyond_course(const Scene& scene, const Object& object) {
  return std::visit(
      [&](const auto& shape) -> std::string_view {
        using S = std::decay_t<decltype(shape)>;
        if constexpr (std::is_same_v<S, Box> || std::is_same_v<S, Square> || std::is_same_v<S, MeshId>) {
          return "";
        } else if constexpr (std::is_same_v<S, Sphere> || std::is_same_v<S, Cylinder> ||
                             std::is_same_v<S, Cone>) {
          return scene.materials[object.material].has_maps() ? "a map on a curved surface" : "";
        } else {
          return "a shape that is not the course's";
        }
      },
      object.shape);
}

}  // namespace

std::string_view beyond_course(const Scene& scene) {
  if (scene.camera.orthographic_height) return "an orthographic camera";
  if (scene.fog) return "fog";
  for (const Light& light : scene.lights) {
    if (std::holds_alternative<SpotLight>(light)) return "a light with a beam";
    if (std::holds_alternative<AreaLight>(light)) return "a light with a size";
  }
  if (std::any_of(scene.materials.begin(), scene.materials.end(),
                  [](const MappedMaterial& m) { return m.has_extras(); })) {
    return "a material with parameters of its own";
  }
  for (const Texture& texture : scene.textures) {
    if (texture.is_solid()) return "a pattern in space";
  }
  for (const MappedMaterial& material : scene.materials) {
    if (material.turns_normals()) return "a map of normals or heights";
  }
  for (const SceneMesh& mesh : scene.meshes) {
    if (mesh.geometry.has_coordinates()) return "a mesh with texture coordinates";
  }
  for (const Object& object : scene.objects) {
    if (const std::string_view what = beyond_course(scene, object); !what.empty()) return what;
  }
  return "";
}

}  // namespace trace
