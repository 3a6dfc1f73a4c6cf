// Adaptive antialiasing as the course's settings mean it.
#pragma once

#include "rendering/film.hpp"
#include "rendering/frame_renderer.hpp"

namespace trace {

// Marks both of two neighbouring pixels (right, above, right above) of the finished picture whose colours are
// further apart than the threshold, then replaces each marked pixel by the mean of n x n samples. The sample
// at the pixel's corner is taken from the picture as it is. A channel that is undefined in any other sample
// is black.
void antialias(FrameRenderer& frame, Film& film);

}  // namespace trace
