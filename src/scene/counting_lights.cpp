#include "scene/counting_lights.hpp"

#include <algorithm>
#include <optional>

namespace trace {
namespace {

bool has_no_direction(const Light& light) {
  const auto* directional = std::get_if<DirectionalLight>(&light);
  return directional && !directional->sample(Vec3(0)).reaches;
}

bool is_black(const Light& light) {
  return std::visit([](const auto& l) { return is_zero(l.color); }, light);
}

bool is_moderate(const Rgb& color) {
  return glm::all(glm::lessThanEqual(glm::abs(color), Rgb(1e100)));
}

// Whether what the surface sends of a light is finite.
bool is_tame(const Material& m) {
  const double shininess = luminance(m.shininess);
  return is_moderate(m.diffuse) && is_moderate(m.specular) && shininess >= 0 && shininess <= 1e6;
}

bool is_lit(const Material& m) {
  return !is_zero(m.diffuse) || !is_zero(m.specular);
}
bool is_lit(const MappedMaterial& m) {
  return is_lit(m.values) || m.diffuse >= 0 || m.specular >= 0;
}

// The weights that mix the materials of a mesh's points are off by roundings, one may be a little negative:
// what is mixed of exponents so different that this shows could be negative.
bool shininess_mixes(const std::vector<Material>& materials) {
  const auto [low, high] =
      std::ranges::minmax(materials, {}, [](const Material& m) { return luminance(m.shininess); });
  return luminance(high.shininess) <= 1e3 * luminance(low.shininess);
}

bool all_tame(const Scene& scene) {
  return std::ranges::all_of(scene.materials, [](const MappedMaterial& m) { return is_tame(m.values); }) &&
         std::ranges::all_of(scene.meshes, [](const SceneMesh& mesh) {
           return mesh.materials.empty() ||
                  (std::ranges::all_of(mesh.materials, is_tame) && shininess_mixes(mesh.materials));
         });
}

bool any_lit(const Scene& scene) {
  return std::ranges::any_of(scene.materials, [](const MappedMaterial& m) { return is_lit(m); }) ||
         std::ranges::any_of(scene.meshes, [](const SceneMesh& mesh) {
           return std::ranges::any_of(mesh.materials, [](const Material& m) { return is_lit(m); });
         });
}

}  // namespace

CountingLights lights_that_count(const Scene& scene) {
  const bool none_lit = !any_lit(scene);
  // Asked of a large mesh only where it matters.
  std::optional<bool> known;
  const auto nothing_stays_nothing = [&] {
    if (!known) known = !scene.shadow_may_be_undefined && all_tame(scene);
    return *known;
  };
  CountingLights result;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    if (has_no_direction(light)) {
      result.culled.push_back({i, WhyCulled::no_direction});
    } else if (is_black(light) && nothing_stays_nothing()) {
      result.culled.push_back({i, WhyCulled::black});
    } else if (none_lit && nothing_stays_nothing()) {
      result.culled.push_back({i, WhyCulled::nothing_reflects});
    } else {
      result.lights.push_back(light);
    }
  }
  return result;
}

std::string_view to_text(WhyCulled why) {
  switch (why) {
    case WhyCulled::no_direction:
      return "without a direction";
    case WhyCulled::black:
      return "black";
    case WhyCulled::nothing_reflects:
      break;
  }
  return "no surface reflects it";
}

}  // namespace trace
