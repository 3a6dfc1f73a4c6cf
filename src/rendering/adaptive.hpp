// Our own adaptive antialiasing: as many samples as the contrast between a pixel's corners is worth.
//
// Whatever makes an edge in the picture (geometry, material, shadow, texture, and all of them seen in mirrors
// and through glass) makes the colours of the corners differ; where they do not, an edge costs no error.
#pragma once

#include <cstdint>
#include <vector>

#include "rendering/contrast.hpp"
#include "rendering/film.hpp"
#include "rendering/frame_renderer.hpp"

namespace trace {

// One sample at each corner of each pixel: (width + 1) x (height + 1), each shared by four pixels.
class CornerSamples {
 public:
  // Traces them all.
  explicit CornerSamples(FrameRenderer& frame);

  // The mean of a pixel's corners: exact to second order where colours change smoothly. j from the bottom.
  Rgb mean(int i, int j) const;

  // The bins (contrast.hpp) of all pixels, row by row from the bottom. A pixel's contrast is the largest
  // difference of any channel between its corners, or a quarter of that of one of its eight neighbours if
  // that is more: an edge may enter a pixel between its corners.
  std::vector<std::uint8_t> contrasts(FrameRenderer& frame) const;

 private:
  struct Color {
    float r, g, b;
  };
  const Color& at(int i, int j) const {
    return colors_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
                   static_cast<std::size_t>(i)];
  }
  float contrast(int i, int j) const;

  int columns_;
  std::vector<Color> colors_;
};

// Samples each pixel by its contrast: the mean of n x n samples (uniform.hpp), or of its corners for n = 0.
// Where samples differ by more than the corners said, half of that counts as a contrast of the pixel and its
// neighbours too (a line goes on into two or three of the eight), and so on from them.
void refine(FrameRenderer& frame, Film& film, const CornerSamples& corners,
            std::vector<std::uint8_t> contrasts, const GridByContrast& grids);

// All of it.
void render_adaptive(FrameRenderer& frame, Film& film, const GridByContrast& grids);

}  // namespace trace
