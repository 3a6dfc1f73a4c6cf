// What a study says over all its scenes.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "study/results.hpp"

namespace trace {

// Geometric means over the scenes that have the setting, of its time and error relative to the base setting.
struct OverallSetting {
  std::string name;
  double time = 0, error = 0;
  std::size_t scenes = 0;
  bool front = false;
};

// How many times as fast: the geometric mean over scenes, and the extremes.
struct Claim {
  std::string text;
  double times = 0, low = 0, high = 0;
  std::size_t scenes = 0;
};

// How often an error budget was kept.
struct BudgetKept {
  double asked = 0;  // levels
  std::size_t scenes = 0;
  std::size_t within = 0;  // off by at most what was asked
  std::size_t nearly = 0;  // by at most 1.5 times that, what was kept among them
  double worst = 0;        // times what was asked
};

struct Overall {
  std::size_t scenes = 0;  // that were studied
  std::vector<OverallSetting> settings;
  std::vector<Claim> claims;
  std::vector<BudgetKept> budgets;
};

// Errors below the converged picture's own count as that; scenes whose base setting is no more than that off
// (black pictures) say nothing of errors and are left out. So are arithmetic, whose error is another, and
// needs, which have none; both have claims.
Overall overall(std::span<const SceneResult> scenes);

// How much less time the settings on `axis` take than uniform sampling of the same error: for each of them
// whose error lies between those of the coarsest and the finest uniform sampling, the time of uniform
// sampling at that error (a line between the neighbouring steps on logarithmic scales) over its own; of these
// the geometric mean. 0 where there are none.
double speed_up_at_equal_error(const SceneResult& scene, Axis axis);

}  // namespace trace
