#include "comparison/measure.hpp"

#include <cmath>

#include "comparison/edge_tolerant.hpp"
#include "comparison/flip.hpp"
#include "comparison/percentiles.hpp"
#include "comparison/pixel_differences.hpp"
#include "comparison/ssim.hpp"
#include "comparison/worst_regions.hpp"

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
  const PixelDifferences differences = pixel_differences(reference, test);
  sum_errors(differences, result);
  count_pixels(differences, result);
  result.largest = differences.largest;
  result.not_finite = differences.not_finite;
  if (result.identical()) {
    if (options.ssim) result.ssim = 1;
    if (options.flip) result.flip = 0;
    return result;
  }
  result.percentiles = percentiles(differences.levels);
  result.edge_tolerant = edge_tolerant(reference, test, differences);
  result.worst = worst_regions(reference, test, differences);
  if (options.ssim) result.ssim = ssim(reference, test, differences.levels, options.threads);
  if (options.flip) result.flip = flip(reference, test, differences.levels, options.threads);
  return result;
}

}  // namespace trace
