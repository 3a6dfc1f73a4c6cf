#include "rendering/budget.hpp"

#include <chrono>
#include <cmath>

#include "rendering/allocation.hpp"
#include "rendering/depth_pilot.hpp"

namespace trace {
namespace {

using Clock = std::chrono::steady_clock;

// Predictions are aimed below the error asked for by what they are off themselves: measured over the course's
// scenes (docs/results/speed-vs-error.md).
constexpr double aim = 0.85;
// The share of the squared error that a depth may take.
constexpr double depth_share = 0.25;
// Ray trees larger than this are not followed: glass within glass can double them with each bounce.
constexpr double most_rays_per_sample = 500;
// No one sees what such a depth loses; for times.
constexpr double negligible_error = 0.02;
// The share of what is left of a time that the samples at the corners may take: what a bounce loses is mostly
// more than samples gain.
constexpr double corners_share = 0.85;
// The share of a time that may be planned for: the rest is for what pilots do not see, and for the samples
// that following lines takes (adaptive.hpp).
constexpr double planned_share = 0.7;
// The share of a time that finding the depth may take.
constexpr double depth_pilot_share = 0.15;

double square(double x) {
  return x * x;
}

// The cheapest that is good enough, else the best.
const DepthStep& depth_for_error(const DepthPilot& pilot, double error) {
  for (const DepthStep& step : pilot.steps) {
    if (square(step.error) + square(pilot.left) <= depth_share * square(error)) return step;
  }
  return pilot.steps.back();
}

// The first that loses nothing to speak of, or the deepest that leaves time for a sample at each corner.
const DepthStep& depth_for_time(const DepthPilot& pilot, double corners, double seconds) {
  const DepthStep* best = &pilot.steps.front();
  for (const DepthStep& step : pilot.steps) {
    if (step.seconds_per_sample * corners > seconds) break;
    best = &step;
    if (step.error <= negligible_error) break;
  }
  return *best;
}

}  // namespace

double BudgetOutcome::error() const {
  return std::hypot(sampling_error, depth_error);
}

WithinBudget render_within(const Budget& budget, const Scene& scene, const SceneTree& tree,
                           RenderOptions options, Progress& progress) {
  const auto begin = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  const auto left = [&] { return budget.seconds * planned_share - elapsed(); };
  const int height = static_cast<int>(picture_height(scene, options.width));
  const double pixels = static_cast<double>(options.width) * height;
  const double corners_count = (options.width + 1.0) * (height + 1.0);
  progress.total = static_cast<std::uint64_t>(corners_count + 2 * pixels);
  const bool for_error = budget.error > 0;
  const double no_limit = std::numeric_limits<double>::infinity();

  WithinBudget result;
  BudgetOutcome& outcome = result.outcome;
  if (!budget.fixed_depth) {
    const DepthPilot depths = pilot_depth(
        scene, tree, options, height, max_depth, for_error ? budget.error / 16 : negligible_error / 2,
        most_rays_per_sample, for_error ? no_limit : budget.seconds * depth_pilot_share);
    const DepthStep& step = for_error ? depth_for_error(depths, aim * budget.error)
                                      : depth_for_time(depths, corners_count, left() * corners_share);
    options.depth = step.depth;
    outcome.depth_error = std::hypot(step.error, depths.left);
  }
  outcome.depth = options.depth;

  Film film(options.width, height, options.keep_colors);
  FrameRenderer frame(scene, tree, options, height, threads_or_all(options.threads), progress);
  const CornerSamples corners(frame);
  std::vector<std::uint8_t> contrasts = corners.contrasts(frame);
  const SamplingPilot pilot = pilot_sampling(frame, corners, contrasts);
  // Where the depth alone is beyond what is asked, samples are to cost no more than if it were not.
  const double asked = square(for_error ? aim * budget.error : negligible_error);
  const double most_square = std::max(asked - square(outcome.depth_error), asked * depth_share);
  const double most_samples =
      for_error ? no_limit : std::max(0.0, left()) / std::max(pilot.seconds_per_sample, 1e-12);
  const Allocation allocation = allocate(pilot, most_square, most_samples);
  const std::uint64_t before = frame.counts().primary;
  refine(frame, film, corners, std::move(contrasts), allocation.grids);
  const std::uint64_t samples = frame.counts().primary - before;

  outcome.grids = allocation.grids;
  outcome.samples_per_pixel = (corners_count + static_cast<double>(samples)) / pixels;
  outcome.sampling_error = std::sqrt(allocation.square_error);
  outcome.met = for_error ? outcome.error() <= budget.error : elapsed() <= budget.seconds;
  result.rendered = {std::move(film.image()), std::move(film.colors()), frame.counts(),
                     frame.non_finite().found()};
  return result;
}

}  // namespace trace
