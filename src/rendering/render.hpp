// Scene to picture: the whole interface of the renderer.
#pragma once

#include "image/image.hpp"
#include "rendering/color_image.hpp"
#include "rendering/non_finite.hpp"
#include "rendering/options.hpp"
#include "rendering/progress.hpp"

namespace trace {

struct Rendered {
  Image image;
  ColorImage colors;  // where options.keep_colors; what the image's bytes were cut from
  RayCounts rays;
  NonFinitePixels non_finite;
};

// Rows of the picture: int(width / aspect ratio + 0.5). Below 1, or beyond image/size_limits.hpp, there is no
// picture.
double picture_height(const Scene& scene, int width);

// The same bytes for any number of threads. Options must be within the limits of options.hpp and
// picture_height within those of a picture.
Rendered render(const Scene& scene, const SceneTree& tree, const RenderOptions& options, Progress& progress);

}  // namespace trace
