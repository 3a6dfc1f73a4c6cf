// A picture no worse, or no later, than asked: the least work for an error, or the least error for a time.
//
// Two pilots measure what depth and samples are worth in this picture (depth_pilot.hpp, sampling_pilot.hpp)
// and what they cost; from that the setting is chosen (allocation.hpp), rendered, and its error predicted. An
// error is an RMSE in levels (1/255) over all channels, before colours are cut to bytes, against the picture
// with as many samples and bounces as change anything, or with options.depth bounces where that is kept.
#pragma once

#include "rendering/contrast.hpp"
#include "rendering/render.hpp"

namespace trace {

// The least error that can be asked for, in levels: of the finest samples little more is left.
inline constexpr double least_error = 0.05;

// Either an error or a time is asked for; the other is 0.
struct Budget {
  double error = 0;    // levels
  double seconds = 0;  // for render_within itself

  bool asked() const { return error > 0 || seconds > 0; }

  bool fixed_depth = false;  // options.depth is kept; nothing deeper counts as truth
};

struct BudgetOutcome {
  int depth = 0;
  GridByContrast grids{};                      // samples by contrast
  double samples_per_pixel = 0;                // as they were taken, without the pilots'
  double sampling_error = 0, depth_error = 0;  // levels, as predicted
  double error() const;                        // of both together
  bool met = true;  // as predicted; false where the ladder ends or time runs out before
};

struct WithinBudget {
  Rendered rendered;
  BudgetOutcome outcome;
};

// options.sampling, antialiasing and blocks count for nothing. The picture for an error is the same on every
// run and for any number of threads; that for a time is not.
WithinBudget render_within(const Budget& budget, const Scene& scene, const SceneTree& tree,
                           RenderOptions options, Progress& progress);

}  // namespace trace
