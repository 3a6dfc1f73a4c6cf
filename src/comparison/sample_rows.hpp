// A picture's rows as one array a channel, in units in which differences of integers are exact.
#pragma once

#include <span>
#include <vector>

#include "image/raster.hpp"

namespace trace {

// What one unit of a row stands for, so that the samples of both pictures are whole numbers of units where
// both files hold integers: n / 255 is the level n, n / 65535 is n units of 1/257 of a level. Where either
// picture holds floating-point numbers a unit is full scale, 255 levels.
struct SampleUnit {
  float per_full_scale = 255;
  bool whole = true;

  double levels(double units) const { return units * 255 / static_cast<double>(per_full_scale); }
};

SampleUnit common_unit(const Raster& a, const Raster& b);

// Row y of `raster` into one plane a channel: sample x goes to planes[channel * stride + x].
void load_row(const Raster& raster, int y, SampleUnit unit, std::span<float> planes, std::size_t stride);

}  // namespace trace
