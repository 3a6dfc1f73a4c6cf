// The structural similarity index.
#pragma once

#include <vector>

#include "image/raster.hpp"

namespace trace {

// Mean SSIM of Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli, "Image Quality Assessment: From Error
// Visibility to Structural Similarity", IEEE Transactions on Image Processing 13 (2004): a Gaussian window of
// 11 x 11 pixels with a standard deviation of 1.5, K1 = 0.01, K2 = 0.03, L = 255; the mean over all positions
// at which the whole window lies in the picture. Where the picture is less than 11 pixels wide or high the
// window has the largest odd size that fits in that direction, its weights again adding up to 1.
//
// On luma, 0.299 R + 0.587 G + 0.114 B (ITU-R Rec. BT.601), as the authors' program is used on colour
// pictures; on shown_color.hpp's colours. 1 for equal pictures, at least -1. `differences` are those of
// pixel_differences.hpp. The same for any number of threads.
double ssim(const Raster& reference, const Raster& test, const std::vector<float>& differences,
            unsigned threads = 1);

}  // namespace trace
