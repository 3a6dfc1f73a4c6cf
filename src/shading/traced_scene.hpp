// What the rays of a picture are traced in: the scene, how it is searched, the switches, and what of it they
// need, worked out once.
#pragma once

#include <optional>
#include <vector>

#include "acceleration/scene_tree.hpp"
#include "scene/scene.hpp"
#include "shading/options.hpp"

namespace trace {

class TracedScene {
 public:
  // Refers to its arguments, which must outlive it.
  TracedScene(const Scene& scene, const SceneTree& tree, const ShadingOptions& options);

  const Scene& scene() const { return scene_; }
  const SceneTree& tree() const { return tree_; }
  const ShadingOptions& options() const { return options_; }

  // Those that count, or all where everything is modelled; a light with a size is its samples.
  const std::vector<PlainLight>& lights() const { return lights_; }
  std::size_t culled_lights() const { return culled_lights_; }

  // What rays that hit nothing look up. None: they see black without looking.
  const CubeMap* surroundings() const {
    if (scene_.cube_map) return &*scene_.cube_map;
    return black_ ? &*black_ : nullptr;
  }

  // Whether rays that add nothing are traced, and what they see thrown away. Not with a least contribution:
  // nothing is less than any.
  bool traces_for_nothing() const { return options_.model_everything && !(options_.least_contribution > 0); }

 private:
  const Scene& scene_;
  const SceneTree& tree_;
  const ShadingOptions& options_;
  std::vector<PlainLight> lights_;
  std::size_t culled_lights_ = 0;
  std::optional<CubeMap> black_;
};

}  // namespace trace
