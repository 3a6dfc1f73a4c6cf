// The same number of samples in every pixel.
#pragma once

#include "rendering/film.hpp"
#include "rendering/frame_renderer.hpp"

namespace trace {

// Each pixel is the mean of n x n samples in the middles of equal parts of it (or at another place of each
// part, both coordinates from 0 to 1); the pixel in column i and row j is the rectangle from its corner,
// where the course takes its one sample, to that of (i + 1, j + 1).
void render_uniform(FrameRenderer& frame, Film& film, int n, const Vec2& place = Vec2(0.5));

}  // namespace trace
