// Nine points of every pixel: its corners, the middles of its edges, and its centre.
#pragma once

#include "rendering/film.hpp"
#include "rendering/frame_renderer.hpp"

namespace trace {

// Each pixel is the mean of the nine, each limited to [0, 1]. Neighbours share theirs: some 4.25 samples a
// pixel are traced. The pixel is the rectangle of uniform.hpp.
void render_nine_points(FrameRenderer& frame, Film& film);

}  // namespace trace
