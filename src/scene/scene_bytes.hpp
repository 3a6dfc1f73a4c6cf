// How much memory a scene takes.
#pragma once

#include <cstddef>

#include "scene/scene.hpp"

namespace trace {

// Of the lists that it holds, by their lengths; what allocators add is not counted.
struct SceneBytes {
  std::size_t meshes = 0;    // points, normals, faces, materials of points
  std::size_t textures = 0;  // pixels of maps and of the cube map
  std::size_t rest = 0;      // objects, frames, materials, lights

  std::size_t total() const { return meshes + textures + rest; }
};

SceneBytes bytes_of(const Scene& scene);

}  // namespace trace
