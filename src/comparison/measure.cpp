#include "comparison/measure.hpp"

#include <cmath>

#include "comparison/edge_tolerant.hpp"
#include "comparison/percentiles.hpp"
#include "comparison/perceptual/flip.hpp"
#include "comparison/perceptual/ssim.hpp"
#include "comparison/pixel_differences.hpp"
#include "comparison/worst_regions.hpp"
#include "parallel/parallel.hpp"

namespace trace {
namespace {

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

// Shares of pixels, and what follows from them.
void count_pixels(const PixelDifferences& differences, Measurements& result) {
  std::size_t pixels = 0, different = 0, over_one = 0, over_threshold = 0;
  for (const float level : differences.levels) {
    pixels += level != left_out;
    different += level > 0;
    over_one += over(level, 1);
    over_threshold += level > 0 && over(level, result.threshold);
  }
  result.percent_different = percent(different, pixels);
  result.percent_over_one = percent(over_one, pixels);
  result.percent_over_threshold = percent(over_threshold, pixels);
  // Every pixel that differs is in the foreground.
  result.foreground.percent_over_one = percent(over_one, differences.foreground_pixels);
}

void sum_errors(const PixelDifferences& differences, Measurements& result) {
  const double levels = differences.unit.levels(1);
  ErrorSum all;
  for (const ErrorSum& sum : differences.channel) {
    result.channel.push_back(sum.figures(levels));
    all += sum;
  }
  result.error = all.figures(levels);
  all.count = differences.foreground_samples;
  result.foreground.pixels = differences.foreground_pixels;
  result.foreground.error = all.figures(levels);
}

}  // namespace

Measurements measure(const Raster& reference, const Raster& test, const MeasureOptions& options) {
  Measurements result;
  result.width = reference.width;
  result.height = reference.height;
  result.channels = reference.channels;
  result.threshold = options.threshold;
  const PixelDifferences differences = pixel_differences(reference, test, options.threads);
  sum_errors(differences, result);
  count_pixels(differences, result);
  result.largest = differences.largest;
  result.not_finite = differences.not_finite;
  if (result.identical()) {
    if (options.ssim) result.ssim = 1;
    if (options.flip) result.flip = 0;
    return result;
  }

  std::optional<Ssim> ssim;
  std::optional<Flip> flip;
  const bool finite = result.not_finite.reference + result.not_finite.test == 0;
  if (options.ssim && finite) ssim.emplace(reference, test, differences.levels);
  if (options.flip && finite) flip.emplace(reference, test, differences.levels);
  const std::size_t flip_parts = flip ? flip->parts() : 0, ssim_parts = ssim ? ssim->parts() : 0;
  struct Scratch {
    Flip::Scratch flip;
    Ssim::Scratch ssim;
  };
  parallel_for_with(
      static_cast<int>(options.threads), flip_parts + ssim_parts + 3, [](int) { return Scratch(); },
      [&](std::size_t part, Scratch& scratch) {
        if (part == 0) result.edge_tolerant = edge_tolerant(reference, test, differences);
        if (part == 1) result.percentiles = percentiles(differences.levels);
        if (part == 2) result.worst = worst_regions(reference, test, differences);
        if (part >= 3 + flip_parts)
          ssim->measure_part(part - 3 - flip_parts, scratch.ssim);
        else if (part >= 3)
          flip->measure_part(part - 3, scratch.flip);
      });
  if (ssim) result.ssim = ssim->mean();
  if (flip) result.flip = flip->mean();
  return result;
}

}  // namespace trace
