// Block interpolation: the course's `threshold` setting, which traces corners and fills what is alike.
#pragma once

#include "rendering/film.hpp"
#include "rendering/frame_renderer.hpp"

namespace trace {

// Cuts the picture into blocks from the lower left. A block whose four corner pixels are no further apart
// than the threshold is filled between them bilinearly; another is cut into four halves, down to 2 x 2. An
// undefined colour is like no other.
void render_blocks(FrameRenderer& frame, Film& film);

}  // namespace trace
