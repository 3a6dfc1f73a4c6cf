#include "study/converged.hpp"

#include <chrono>
#include <cmath>

#include "rendering/depth_pilot.hpp"
#include "rendering/render.hpp"
#include "rendering/uniform.hpp"
#include "study/picture_error.hpp"

namespace trace {
namespace {

// Levels that a step of depth may change when nothing more is to be seen of it.
constexpr double settled_error = 0.02;
// Trees that take more rays than this a sample are not followed further.
constexpr double most_rays_per_sample = 48;
// Rays in all, at most, as far as there is a choice: some seconds.
constexpr double most_rays = 3e8;

// What a part of the samples says, of a grid of 2 n x 2 n the n x n that lie at one place of each part.
ColorImage quarter(FrameRenderer& frame, int n, double x, double y) {
  Film film(frame.width(), frame.height(), true);
  render_uniform(frame, film, n, Vec2(x, y));
  return std::move(film.colors());
}

// RMSE in levels of the mean of a and b against the mean of all four, half their difference.
double half_difference(const ColorImage& a, const ColorImage& b, const ColorImage& c, const ColorImage& d) {
  return picture_error(mean(a, b), mean(c, d)).root_mean_square / 2;
}

}  // namespace

Converged converge(const Scene& scene, const SceneTree& tree, const RenderOptions& options,
                   bool fixed_depth) {
  const auto begin = std::chrono::steady_clock::now();
  const int height = static_cast<int>(picture_height(scene, options.width));
  const DepthPilot pilot =
      pilot_depth(scene, tree, options, height, fixed_depth ? options.depth : max_depth, settled_error / 2,
                  fixed_depth ? std::numeric_limits<double>::infinity() : most_rays_per_sample);
  Converged result;
  for (const DepthStep& step : pilot.steps) result.depths.push_back(step.depth);
  const DepthStep& deepest = pilot.steps.back();
  result.depth = result.settled_depth = deepest.depth;
  for (const DepthStep& step : pilot.steps) {
    if (step.error > settled_error) continue;
    result.settled_depth = step.depth;
    break;
  }

  const double samples_in_reach = most_rays / (deepest.rays_per_sample * options.width * height);
  int n = 3;
  for (const int finer : {4, 6, 8, 12, 16}) {
    if (4 * finer * finer <= samples_in_reach) n = finer;
  }
  RenderOptions deep = options;
  deep.depth = result.depth;
  Progress progress;
  FrameRenderer frame(scene, tree, deep, height, threads_or_all(options.threads), progress);
  const ColorImage a = quarter(frame, n, 0.25, 0.25), b = quarter(frame, n, 0.75, 0.75);
  const ColorImage c = quarter(frame, n, 0.25, 0.75), d = quarter(frame, n, 0.75, 0.25);
  result.colors = mean(mean(a, b), mean(c, d));
  result.samples = 4 * n * n;
  if (!pilot.settled) result.unsettled = pilot.left;
  const double left = fixed_depth || !pilot.settled ? 0 : pilot.left;
  const double chessboard = half_difference(a, b, c, d);
  const double columns = half_difference(a, c, b, d), rows = half_difference(a, d, b, c);
  result.error = std::sqrt(chessboard * chessboard + (columns * columns + rows * rows) / 6 + left * left);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace trace
