// The structural similarity index.
#pragma once

#include <cstddef>
#include <vector>

#include "comparison/perceptual/convolution.hpp"
#include "comparison/perceptual/tiles.hpp"
#include "image/raster.hpp"

namespace trace {

// The weights of a window's columns and rows.
struct SsimWindow {
  std::vector<float> across, down;
};

// Mean SSIM of Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli, "Image Quality Assessment: From Error
// Visibility to Structural Similarity", IEEE Transactions on Image Processing 13 (2004): a Gaussian window of
// 11 x 11 pixels with a standard deviation of 1.5, K1 = 0.01, K2 = 0.03, L = 255; the mean over all positions
// at which the whole window lies in the picture. Where the picture is less than 11 pixels wide or high the
// window has the largest odd size that fits in that direction, its weights again adding up to 1.
//
// On luma, 0.299 R + 0.587 G + 0.114 B (ITU-R Rec. BT.601), as the authors' program is used on colour
// pictures; on shown_color.hpp's colours. 1 for equal pictures, at least -1.
//
// Measured tile by tile, in any order and on any threads: construct, measure_part each once, then mean. Both
// pictures must outlive it. `differences` are those of pixel_differences.hpp; they tell where to look.
class Ssim {
 public:
  // Memory of one thread, used again from part to part.
  struct Scratch {
    Plane a, b, squares, product, filtered, mean_a, mean_b, mean_squares, mean_product;
  };

  Ssim(const Raster& reference, const Raster& test, const std::vector<float>& differences);

  std::size_t parts() const { return tiles_.size(); }
  void measure_part(std::size_t part, Scratch& scratch);
  double mean() const;

 private:
  const Raster& reference_;
  const Raster& test_;
  SsimWindow window_;
  double positions_ = 0;
  std::vector<Tile> tiles_;
  std::vector<double> sums_;
};

}  // namespace trace
