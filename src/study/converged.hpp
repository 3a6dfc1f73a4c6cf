// The picture that more samples and more bounces would not change: the truth of a study, with its own error.
#pragma once

#include <string>

#include "acceleration/scene_tree.hpp"
#include "rendering/color_image.hpp"
#include "rendering/options.hpp"

namespace trace {

struct Converged {
  ColorImage colors;
  int samples = 0;  // in each pixel
  int depth = 0;
  // RMSE in levels that it may be off itself. Of its samples, a grid of 2 n x 2 n: half the difference of the
  // two colours of their chessboard, for edges that lie askew; and where edges are upright or level, which
  // both colours see alike, half that of odd and even columns and rows, over the root of 6. For an edge of
  // contrast C at any place of a pixel that is C / n or 0, as often, halved: C / (2 root 2 n) in the root
  // mean square, while the error is up to C / 4 n either way, C / (4 root 3 n) so measured; 1 / root 6 of it.
  // And of its depth: what the last deeper step changed (rendering/depth_pilot.hpp).
  double error = 0;
  double seconds = 0;
  // Ray trees grew too large before the picture was settled: nothing deeper than `depth` counts as truth,
  // although it would change the picture by so many levels more. 0 where it is settled.
  double unsettled = 0;
  std::vector<int> depths;  // those that change the picture, ascending from 0
  int settled_depth = 0;    // the first of which nothing is seen to be lost
};

// Of `options` width and the switches of shading count, and the depth where it is `fixed_depth`. Samples
// become fewer where that would take very long; the error says so.
Converged converge(const Scene& scene, const SceneTree& tree, const RenderOptions& options, bool fixed_depth);

}  // namespace trace
