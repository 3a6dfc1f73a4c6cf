// What the picture loses when ray trees end early, found at a few thousand of its pixels.
#pragma once

#include <limits>
#include <vector>

#include "rendering/options.hpp"
#include "rendering/progress.hpp"

namespace trace {

struct DepthStep {
  int depth;
  double error;               // RMSE in levels against the deepest step
  double rays_per_sample;     // of all kinds
  double seconds_per_sample;  // as it was measured, on all threads
};

struct DepthPilot {
  std::vector<DepthStep> steps;  // depths ascending
  // RMSE in levels that the deepest may still be off: what the last step changed, or what the one after it
  // would have changed where its trees were too large. 0 where no ray was left to go deeper.
  double left = 0;
  bool settled = true;  // false where trees became too large before the picture was settled
};

// The depths that are tried: each, then at ratios of about 1.3.
inline constexpr int pilot_depths[] = {0, 1, 2, 3, 4, 5, 6, 8, 10, 13, 16, 20, 25, 32, 40, 50, 64};

// Goes deeper until no ray goes deeper, or two steps in a row change less than `enough` levels each; stops
// before a step whose trees take more than `most_rays` a sample, and when `most_seconds` are over. `deepest`
// ends the ladder; it is a step itself. With a limit of seconds neighbouring pixels are looked at together,
// so that seconds_per_sample is that of a picture.
DepthPilot pilot_depth(const Scene& scene, const SceneTree& tree, const RenderOptions& options, int height,
                       int deepest, double enough, double most_rays,
                       double most_seconds = std::numeric_limits<double>::infinity());

}  // namespace trace
