#include "rendering/allocation.hpp"

namespace trace {

Allocation allocate(const SamplingPilot& pilot, double square_error, double samples) {
  Allocation result;
  double pixels = 0, sum = 0;  // of squared errors over all pixels
  for (const ContrastErrors& bin : pilot.bins) {
    pixels += bin.pixels;
    sum += bin.pixels * bin.square[0];
  }
  if (pixels == 0) return result;
  std::array<std::size_t, contrast_bins> steps{};
  while (sum > square_error * pixels) {
    double best = 0, best_cost = 0, best_gain = 0;
    std::size_t best_bin = 0, best_step = 0;
    for (std::size_t b = 0; b < contrast_bins; ++b) {
      const ContrastErrors& bin = pilot.bins[b];
      const auto squared = [](std::size_t step) {
        return static_cast<double>(grid_ladder[step] * grid_ladder[step]);
      };
      for (std::size_t step = steps[b] + 1; step < grid_ladder.size(); ++step) {
        const double gain = bin.pixels * (bin.square[steps[b]] - bin.square[step]);
        const double cost = bin.pixels * (squared(step) - squared(steps[b]));
        if (gain <= best * cost || result.samples + cost > samples) continue;
        best = gain / cost;
        best_gain = gain, best_cost = cost;
        best_bin = b, best_step = step;
      }
    }
    if (best_step == 0) break;
    steps[best_bin] = best_step;
    result.samples += best_cost;
    sum -= best_gain;
  }
  for (std::size_t b = 0; b < contrast_bins; ++b) result.grids[b] = grid_ladder[steps[b]];
  result.square_error = std::max(0.0, sum / pixels);
  return result;
}

}  // namespace trace
