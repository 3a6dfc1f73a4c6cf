// What a scene needs of the renderer, and what therefore is never built or computed for it.
//
// What is not modelled because it adds nothing, and where that is decided, for one ray and for packets
// alike:
//
//   lights that change nothing in the whole scene           lights_that_count(), counting_lights.hpp
//   shadow rays of surfaces that show nothing of a light    shade_locally(), shading/local_shading.cpp
//   what shadow rays would meet behind their first hit      shadow_attenuation(), shading/shadow.cpp
//   powers of highlights of no colour                       needs_highlight(), shading/local_shading.hpp
//   mirrored and refracted rays of surfaces that do         WhittedTracer::trace(), shading/whitted.cpp
//     neither
//   lookups of surroundings that are black                  TracedScene::surroundings()
//   materials through maps that they do not have            evaluates_maps(), shading/surface.hpp
//   a hierarchy over a handful of objects                   SceneTree's `always_sorted`
//
// ShadingOptions::model_everything switches all of them off but the last, which is the hierarchy's. Then it
// is all computed and thrown away: not multiplied by 0 and added, since 0 times infinity is undefined. Ray
// trees are then full ones, with up to 2^depth rays at the last bounce.
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

// "reflected rays", "nothing mirrors"
struct LeftOut {
  std::string what, why;
};

// All that is left out, lights that do not count last ("light 2 of 3"). Where everything is modelled, that is
// only what cannot be made up: what meshes do not hold, and decoders.
std::vector<LeftOut> left_out(const Scene& scene, bool everything_modelled);

}  // namespace trace
