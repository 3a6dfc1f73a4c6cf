// How different two pictures look to a person who flips back and forth between them.
#pragma once

#include <vector>

#include "image/raster.hpp"

namespace trace {

// Mean FLIP for pictures of low dynamic range: P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson,
// K. Astroem, M. D. Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proceedings of the ACM
// on Computer Graphics and Interactive Techniques 3 (2020). Seen as its authors propose, from 0.7 m on a
// screen 0.7 m and 3840 pixels wide: 67.0206 pixels a degree. From 0, equal, to 1.
//
// Of shown_color.hpp's colours, taken as sRGB; that clamps pictures of floating-point numbers to [0, 1].
// `differences` are those of pixel_differences.hpp. The same for any number of threads.
double flip(const Raster& reference, const Raster& test, const std::vector<float>& differences,
            unsigned threads = 1);

}  // namespace trace
