// Scene to picture: the whole interface of the renderer.
#pragma once

#include "image/image.hpp"
#include "rendering/options.hpp"
#include "rendering/progress.hpp"

namespace trace {

struct Rendered {
  Image image;
  RayCounts rays;
};

// Rows of the picture: int(width / aspect ratio + 0.5). Below 1, or beyond max_pixels, there is no picture.
double picture_height(const Scene& scene, int width);

// The same bytes for any number of threads. Options must be within the limits of options.hpp and picture_height at
// least 1.
Rendered render(const Scene& scene, const SceneTree& tree, const RenderOptions& options, Progress& progress);

}  // namespace trace
