#include "scene/needs.hpp"

namespace trace {

SceneNeeds needs_of(const Scene& scene) {
  SceneNeeds needs;
  needs.transmission = scene.has_transmissive_objects;
  needs.surroundings = scene.cube_map.has_value();
  const auto add = [&](const Material& m) {
    needs.reflection |= m.reflects();
    needs.highlights |= !is_zero(m.specular);
  };
  for (const MappedMaterial& material : scene.materials) {
    add(material.values);
    needs.maps |= material.has_maps();
    needs.highlights |= material.specular != no_texture;
  }
  for (const SceneMesh& mesh : scene.meshes) {
    needs.smooth_normals |= mesh.geometry.smooth();
    needs.vertex_materials |= !mesh.materials.empty();
    for (const Material& material : mesh.materials) add(material);
  }
  return needs;
}

std::vector<std::string> left_out(const SceneNeeds& needs) {
  std::vector<std::string> result;
  const auto note = [&](bool needed, const char* what) {
    if (!needed) result.emplace_back(what);
  };
  note(needs.transmission,
       "refracted rays, and shadow rays behind their first hit (nothing lets light through)");
  note(needs.reflection, "reflected rays (nothing mirrors)");
  note(needs.highlights, "powers of highlights (nothing is specular)");
  note(needs.maps, "texture maps and their decoders (no material has one)");
  note(needs.surroundings, "lookups of surroundings (no cube map)");
  note(needs.smooth_normals, "interpolated normals (no mesh has vertex normals)");
  note(needs.vertex_materials, "mixed materials (no mesh has materials of its points)");
  return result;
}

}  // namespace trace
