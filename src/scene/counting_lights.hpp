// Which of a scene's lights can change its picture.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace trace {

enum class WhyCulled {
  no_direction,     // a directional light whose direction is of length zero or not finite: reaches nothing
  black,            // its colour is 0
  nothing_reflects  // no surface has a diffuse or specular colour
};

struct CulledLight {
  std::size_t light;  // index into Scene::lights
  WhyCulled why;
};

struct CountingLights {
  std::vector<Light> lights;  // in the order of the scene
  std::vector<CulledLight> culled;
};

// A light that adds 0 everywhere is culled only where 0 times anything is 0 in this scene: no shadow can be
// undefined (Scene::shadow_may_be_undefined), and what a surface sends of a light is finite, for no colour
// exceeds 1e100 and every shininess is from 0 to 1e6.
CountingLights lights_that_count(const Scene& scene);

// "black"
std::string_view to_text(WhyCulled why);

}  // namespace trace
