#include "comparison/perceptual/ssim.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "comparison/measure.hpp"
#include "rasters.hpp"

using namespace trace;
using namespace trace::test;

namespace {

double luma(const Raster& raster, int x, int y) {
  const float* p = raster.pixel(x, y);
  return 255 * (0.299 * static_cast<double>(p[0]) + 0.587 * static_cast<double>(p[1]) +
                0.114 * static_cast<double>(p[2]));
}

// The formulas of the paper, (13) with (14) to (16), one window after the other.
double plain_ssim(const Raster& a, const Raster& b) {
  const int side = 11;
  double total = 0;
  int windows = 0;
  for (int top = 0; top + side <= a.height; ++top)
    for (int left = 0; left + side <= a.width; ++left) {
      double weights = 0, mean_a = 0, mean_b = 0;
      const auto weight = [](int i, int j) {
        return std::exp(-((i - 5) * (i - 5) + (j - 5) * (j - 5)) / 4.5);
      };
      for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
          weights += weight(i, j);
          mean_a += weight(i, j) * luma(a, left + i, top + j);
          mean_b += weight(i, j) * luma(b, left + i, top + j);
        }
      mean_a /= weights;
      mean_b /= weights;
      double variance_a = 0, variance_b = 0, covariance = 0;
      for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
          const double da = luma(a, left + i, top + j) - mean_a, db = luma(b, left + i, top + j) - mean_b;
          variance_a += weight(i, j) / weights * da * da;
          variance_b += weight(i, j) / weights * db * db;
          covariance += weight(i, j) / weights * da * db;
        }
      const double c1 = 2.55 * 2.55, c2 = 7.65 * 7.65;
      total += (2 * mean_a * mean_b + c1) * (2 * covariance + c2) /
               ((mean_a * mean_a + mean_b * mean_b + c1) * (variance_a + variance_b + c2));
      ++windows;
    }
  return total / windows;
}

}  // namespace

TEST_CASE("SSIM is that of the paper's formulas window by window") {
  const Raster a = noise(40, 33, 1);
  Raster b = noise(40, 33, 2);
  CHECK(*measure(a, b).ssim == Approx(plain_ssim(a, b)).margin(1e-6));
  for (std::size_t i = 0; i < b.samples.size(); ++i)  // a darker copy with a little noise
    b.samples[i] = std::round((0.7F * a.samples[i] + 0.1F * b.samples[i]) * 255) / 255;
  CHECK(*measure(a, b).ssim == Approx(plain_ssim(a, b)).margin(1e-6));
}

TEST_CASE("SSIM of a picture larger than a tile with one spot that differs") {
  const Raster a = noise(150, 140, 3);
  Raster b = a;
  set(b, 130, 128, 1, 0);
  set(b, 131, 129, 2, 255);
  CHECK(*measure(a, b).ssim == Approx(plain_ssim(a, b)).margin(1e-7));
  CHECK(*measure(a, b).ssim < 1);
}

TEST_CASE("SSIM of two plain pictures is that of their luminances") {
  const double c1 = 2.55 * 2.55;
  CHECK(*measure(uniform(16, 16, 3, 100), uniform(16, 16, 3, 150)).ssim ==
        Approx((2 * 100.0 * 150 + c1) / (100.0 * 100 + 150.0 * 150 + c1)).margin(1e-4));
}

TEST_CASE("SSIM does not care which picture is the reference") {
  const Raster a = noise(30, 30, 1), b = noise(30, 30, 2);
  CHECK(*measure(a, b).ssim == *measure(b, a).ssim);
}

TEST_CASE("SSIM of a picture smaller than the window is over a window that fits") {
  const double c1 = 2.55 * 2.55;
  const double plain = (2 * 100.0 * 150 + c1) / (100.0 * 100 + 150.0 * 150 + c1);
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 30}, {30, 5}, {10, 10}})
    CHECK(*measure(uniform(width, height, 1, 100), uniform(width, height, 1, 150)).ssim ==
          Approx(plain).margin(1e-4));
}
