// The part of a scene that a triangle library knows too: its meshes, and the one light of "prim+1shadow".
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace trace::bench {

struct MeshScene {
  Scene scene;  // without its other objects
  Vec3 extra_light{0};
};

// The scene as it is. Throws std::runtime_error with the messages where it has errors.
Scene read_scene(const std::string& file, int width);

// `extra_light` is the first point light; without one a place away from the meshes against the first
// directional light, by twice the diagonal of their box; without any light a place up to the right of the
// eye.
MeshScene read_mesh_scene(const std::string& file, int width);

}  // namespace trace::bench
