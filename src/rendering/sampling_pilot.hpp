// What the picture loses with few samples, found at some hundred pixels of each contrast.
#pragma once

#include <array>
#include <vector>

#include "rendering/adaptive.hpp"

namespace trace {

// What neither corners nor the few pixels that are looked at show, thin lines above all, in levels squared
// over all pixels for the means of corners: measured over the course's scenes, where it is some 0.2 levels in
// one of ten.
inline constexpr double unseen_square = 0.05;

// Of the pixels of one contrast: how many there are, and for each step of grid_ladder the mean squared error
// of a channel, in levels squared. Falls, or stays, from step to step.
struct ContrastErrors {
  double pixels = 0;
  std::array<double, grid_ladder.size()> square{};
};

struct SamplingPilot {
  std::array<ContrastErrors, contrast_bins> bins;
  double seconds_per_sample = 0;  // as it was measured, on all threads
};

SamplingPilot pilot_sampling(FrameRenderer& frame, const CornerSamples& corners,
                             const std::vector<std::uint8_t>& contrasts);

}  // namespace trace
