// The parts of a picture in which two pictures can look different at all. FLIP and SSIM at a pixel depend on
// its surroundings only, and are known where the surroundings are equal.
#pragma once

#include <cstddef>
#include <vector>

namespace trace {

// Half-open, in pixels.
struct Tile {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
};

inline constexpr int tile_side = 128;

// Of the tiles that cover [0, columns) x [0, rows), row by row from the top, those with a difference that is
// not 0 anywhere in [x0 - before, x1 + after) x [y0 - before, y1 + after). `differences` has `width` a row.
std::vector<Tile> tiles_that_differ(int columns, int rows, int before, int after,
                                    const std::vector<float>& differences, int width);

}  // namespace trace
