#include "shading/traced_scene.hpp"

#include "scene/counting_lights.hpp"

namespace trace {
namespace {

CubeMap black_surroundings() {
  const Texture face(Image{1, 1, {0, 0, 0}});
  return CubeMap(std::vector<Texture>(6, face));
}

std::vector<PlainLight> plain_lights(const std::vector<Light>& lights, int samples) {
  std::vector<PlainLight> result;
  for (const Light& light : lights) {
    std::visit(
        [&](const auto& l) {
          if constexpr (std::is_same_v<std::decay_t<decltype(l)>, AreaLight>) {
            std::vector<PlainLight> parts = l.samples(samples);
            result.insert(result.end(), parts.begin(), parts.end());
          } else {
            result.emplace_back(l);
          }
        },
        light);
  }
  return result;
}

std::size_t samples_of(const Light& light, int samples) {
  if (!std::holds_alternative<AreaLight>(light)) return 1;
  return static_cast<std::size_t>(samples) * static_cast<std::size_t>(samples);
}

}  // namespace

TracedScene::TracedScene(const Scene& scene, const SceneTree& tree, const ShadingOptions& options)
    : scene_(scene), tree_(tree), options_(options) {
  if (options.model_everything) {
    lights_ = plain_lights(scene.lights, options.light_samples);
  } else {
    const CountingLights counting = lights_that_count(scene);
    lights_ = plain_lights(counting.lights, options.light_samples);
    for (const CulledLight& culled : counting.culled) {
      culled_lights_ += samples_of(scene.lights[culled.light], options.light_samples);
    }
  }
  if (options.model_everything && !scene.cube_map) black_ = black_surroundings();
}

}  // namespace trace
