#include "shading/traced_scene.hpp"

#include "scene/counting_lights.hpp"

namespace trace {
namespace {

CubeMap black_surroundings() {
  const Texture face(Image{1, 1, {0, 0, 0}});
  return CubeMap(std::vector<Texture>(6, face));
}

}  // namespace

TracedScene::TracedScene(const Scene& scene, const SceneTree& tree, const ShadingOptions& options)
    : scene_(scene),
      tree_(tree),
      options_(options),
      lights_(options.model_everything ? scene.lights : lights_that_count(scene).lights) {
  if (options.model_everything && !scene.cube_map) black_ = black_surroundings();
}

}  // namespace trace
