// What a scene needs of the renderer, and what therefore is never done for it.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace trace {

struct SceneNeeds {
  bool transmission = false;      // a material lets light through: shadow rays go on behind a hit
  bool reflection = false;        // a material mirrors
  bool highlights = false;        // a material has a specular colour: powers are taken
  bool maps = false;              // a material has textures
  bool surroundings = false;      // there is a cube map to look up
  bool smooth_normals = false;    // a mesh has vertex normals
  bool vertex_materials = false;  // a mesh has materials of its points
};

SceneNeeds needs_of(const Scene& scene);

// What is left out, each with its reason: "reflected rays (nothing mirrors)".
std::vector<std::string> left_out(const SceneNeeds& needs);

}  // namespace trace
