// Which contrasts get how many samples so that the picture is best for what it costs.
#pragma once

#include "rendering/sampling_pilot.hpp"

namespace trace {

struct Allocation {
  GridByContrast grids{};
  double samples = 0;       // beside those at the corners
  double square_error = 0;  // mean over the picture's channels, levels squared
};

// Starts at the means of the corners and, step by step, takes the step that lowers the error most for its
// samples (the greedy solution of the allocation by marginal returns), until the squared error is at most
// `square_error` or the next would go beyond `samples`.
Allocation allocate(const SamplingPilot& pilot, double square_error, double samples);

}  // namespace trace
