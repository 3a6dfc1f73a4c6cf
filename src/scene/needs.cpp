#include "scene/needs.hpp"

#include <fmt/format.h>

#include "scene/counting_lights.hpp"

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

std::vector<LeftOut> left_out(const Scene& scene, bool everything_modelled) {
  const SceneNeeds needs = needs_of(scene);
  std::vector<LeftOut> result;
  const auto note = [&](bool needed, const char* what, const char* why) {
    if (!needed) result.push_back({what, why});
  };
  const bool all = everything_modelled;
  note(all || needs.transmission, "refracted rays, and shadow rays behind their first hit",
       "nothing lets light through");
  note(all || needs.reflection, "reflected rays", "nothing mirrors");
  note(all || needs.highlights, "powers of highlights", "nothing is specular");
  note(all || needs.maps, "texture maps and their decoders", "no material has one");
  note(!all || needs.maps, "decoders of texture maps", "no material has one");
  note(all || needs.surroundings, "lookups of surroundings", "no cube map");
  note(needs.smooth_normals, "interpolated normals", "no mesh has vertex normals");
  note(needs.vertex_materials, "mixed materials", "no mesh has materials of its points");
  if (all) return result;
  for (const CulledLight& culled : lights_that_count(scene).culled) {
    result.push_back({fmt::format("light {} of {}", culled.light + 1, scene.lights.size()),
                      std::string(to_text(culled.why))});
  }
  return result;
}

}  // namespace trace
