#include "rendering/sampling_pilot.hpp"

#include <chrono>
#include <cmath>

#include "rendering/pilot_places.hpp"
#include "rendering/sample_sums.hpp"

namespace trace {
namespace {

// Pixels that are looked at in all, and in a bin at least (if it has them).
constexpr double wanted_pixels = 512;
constexpr std::size_t least_in_bin = 24;

// Steps of grid_ladder that are measured, against a finer grid. An error falls as n^-3/2 (contrast.hpp); that
// of the finer grid is in what is measured, and those of later steps follow from the last one measured.
constexpr std::size_t measured_steps = 5;
constexpr int reference_grid = 12;
static_assert(grid_ladder[measured_steps - 1] == 6);

struct Place {
  int i, j;
  std::size_t bin;
};

double squared_levels(const Rgb& difference) {
  return glm::dot(difference, difference) * (255.0 * 255.0 / 3);
}

std::vector<std::vector<std::uint32_t>> pixels_by_bin(const std::vector<std::uint8_t>& contrasts) {
  std::array<std::size_t, contrast_bins> counts{};
  for (const std::uint8_t bin : contrasts) ++counts[bin];
  std::vector<std::vector<std::uint32_t>> result(contrast_bins);
  for (std::size_t bin = 0; bin < contrast_bins; ++bin) result[bin].reserve(counts[bin]);
  for (std::size_t pixel = 0; pixel < contrasts.size(); ++pixel) {
    result[contrasts[pixel]].push_back(static_cast<std::uint32_t>(pixel));
  }
  return result;
}

// More where errors may be larger and pixels are many: Neyman's allocation, with the contrast for the
// deviation.
std::vector<Place> choose(const std::vector<std::vector<std::uint32_t>>& bins, int width) {
  double weight = 0;
  const auto weight_of = [&](std::size_t bin) {
    return contrast_of_bin(static_cast<int>(bin)) * static_cast<double>(bins[bin].size());
  };
  for (std::size_t bin = 0; bin < bins.size(); ++bin) weight += weight_of(bin);
  std::vector<Place> places;
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    const double share = weight > 0 ? weight_of(bin) / weight : 0;
    const std::size_t count =
        std::min(bins[bin].size(), std::max(least_in_bin, static_cast<std::size_t>(wanted_pixels * share)));
    for (std::size_t k = 0; k < count; ++k) {
      const auto pixel = static_cast<int>(bins[bin][pilot_place(k, count, bins[bin].size())]);
      places.push_back({pixel % width, pixel / width, bin});
    }
  }
  return places;
}

}  // namespace

SamplingPilot pilot_sampling(FrameRenderer& frame, const CornerSamples& corners,
                             const std::vector<std::uint8_t>& contrasts) {
  const auto bins = pixels_by_bin(contrasts);
  const std::vector<Place> places = choose(bins, frame.width());
  using Squares = std::array<double, measured_steps>;
  std::vector<Squares> squares(places.size());
  const auto begin = std::chrono::steady_clock::now();
  frame.for_each_tile(static_cast<int>(places.size()), 1, 4,
                      [&](const FrameRenderer::Sampler& sampler, int first, int, int last, int) {
                        SampleSums sums(frame, sampler);
                        for (int k = first; k < last; ++k) {
                          const Place& place = places[static_cast<std::size_t>(k)];
                          for (std::size_t step = 1; step <= measured_steps; ++step) {
                            sums.begin(place.i, place.j);
                            sums.add_grid(place.i, place.j,
                                          step < measured_steps ? grid_ladder[step] : reference_grid);
                          }
                        }
                        std::vector<Rgb> means;
                        sums.finish([&](int, int, const Rgb& mean) { means.push_back(mean); });
                        for (int k = first; k < last; ++k) {
                          const Place& place = places[static_cast<std::size_t>(k)];
                          const Rgb* of_steps = &means[static_cast<std::size_t>(k - first) * measured_steps];
                          const Rgb& truth = of_steps[measured_steps - 1];
                          Squares& result = squares[static_cast<std::size_t>(k)];
                          result[0] = squared_levels(corners.mean(place.i, place.j) - truth);
                          for (std::size_t step = 1; step < measured_steps; ++step) {
                            result[step] = squared_levels(of_steps[step - 1] - truth);
                          }
                        }
                      });
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;

  SamplingPilot result;
  double samples = 0;
  std::array<double, contrast_bins> looked_at{};
  for (std::size_t k = 0; k < places.size(); ++k) {
    looked_at[places[k].bin] += 1;
    for (std::size_t step = 0; step < measured_steps; ++step) {
      result.bins[places[k].bin].square[step] += squares[k][step];
    }
    for (std::size_t step = 1; step < measured_steps; ++step)
      samples += grid_ladder[step] * grid_ladder[step];
    samples += reference_grid * reference_grid;
  }
  result.seconds_per_sample = samples > 0 ? spent.count() / samples : 0;
  for (std::size_t bin = 0; bin < contrast_bins; ++bin) {
    ContrastErrors& errors = result.bins[bin];
    errors.pixels = static_cast<double>(bins[bin].size());
    if (looked_at[bin] == 0) continue;
    for (std::size_t step = 0; step < grid_ladder.size(); ++step) {
      double& square = errors.square[step];
      const double n = grid_ladder[step];
      if (step < measured_steps) {
        square /= looked_at[bin];
        if (n > 0) square /= 1 + std::pow(n / reference_grid, 3);
      } else {
        square = errors.square[measured_steps - 1] * std::pow(grid_ladder[measured_steps - 1] / n, 3);
      }
      square = std::max(square, unseen_square / std::pow(std::max(n, 1.0), 3));
      if (step > 0) square = std::min(square, errors.square[step - 1]);
    }
  }
  return result;
}

}  // namespace trace
