// How different two pictures look to a person who flips back and forth between them.
#pragma once

#include <cstddef>
#include <vector>

#include "comparison/perceptual/flip_seen.hpp"
#include "comparison/perceptual/tiles.hpp"
#include "image/raster.hpp"

namespace trace {

// Mean FLIP for pictures of low dynamic range: P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson,
// K. Astroem, M. D. Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proceedings of the ACM
// on Computer Graphics and Interactive Techniques 3 (2020). Seen as its authors propose, from 0.7 m on a
// screen 0.7 m and 3840 pixels wide: 67.0206 pixels a degree. From 0, equal, to 1.
//
// Of shown_color.hpp's colours, taken as sRGB; that clamps pictures of floating-point numbers to [0, 1].
//
// (The authors' program computes in single precision: on ten pairs of pictures, it and a program in double
// precision differ by up to 0.00043, this one and that by less than 0.00001.)
//
// Measured tile by tile, in any order and on any threads: construct, measure_part each once, then mean. Both
// pictures must outlive it. `differences` are those of pixel_differences.hpp; they tell where to look.
class Flip {
 public:
  // Memory of one thread, used again from part to part.
  struct Scratch {
    FlipObserver observer;
    FlipSeen reference, test;
  };

  Flip(const Raster& reference, const Raster& test, const std::vector<float>& differences);

  std::size_t parts() const { return tiles_.size(); }
  void measure_part(std::size_t part, Scratch& scratch);
  double mean() const;

 private:
  const Raster& reference_;
  const Raster& test_;
  FlipTools tools_;
  std::vector<Tile> tiles_;
  std::vector<double> sums_;
};

}  // namespace trace
