// Two pictures of the same size and channels to their measurements. The definition of each figure, with its
// source, is in measurements.hpp, ssim.hpp and flip.hpp.
#pragma once

#include "comparison/measurements.hpp"
#include "image/raster.hpp"

namespace trace {

struct MeasureOptions {
  double threshold = 1;  // levels, for percent_over_threshold
  bool ssim = true;
  bool flip = true;
  unsigned threads = 2;  // at most; the figures are the same for any number
};

// Needs equal width, height and channels. Samples that are not finite in either picture are counted and left
// out of every other figure; SSIM and FLIP, which are of whole neighbourhoods, are then absent.
Measurements measure(const Raster& reference, const Raster& test, const MeasureOptions& options = {});

}  // namespace trace
