#include "comparison/perceptual/tiles.hpp"

#include <algorithm>

namespace trace {
namespace {

bool differs(const Tile& tile, const std::vector<float>& differences, int width) {
  const auto other_than_0 = [](float difference) { return difference != 0; };
  for (int y = tile.y0; y < tile.y1; ++y) {
    const float* row = &differences[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)];
    if (std::any_of(row + tile.x0, row + tile.x1, other_than_0)) return true;
  }
  return false;
}

}  // namespace

std::vector<Tile> tiles_that_differ(int columns, int rows, int before, int after,
                                    const std::vector<float>& differences, int width) {
  const int height = static_cast<int>(differences.size() / static_cast<std::size_t>(width));
  std::vector<Tile> tiles;
  for (int y = 0; y < rows; y += tile_side)
    for (int x = 0; x < columns; x += tile_side) {
      const Tile tile{x, y, std::min(x + tile_side, columns), std::min(y + tile_side, rows)};
      const Tile seen{std::max(0, tile.x0 - before), std::max(0, tile.y0 - before),
                      std::min(width, tile.x1 + after), std::min(height, tile.y1 + after)};
      if (differs(seen, differences, width)) tiles.push_back(tile);
    }
  return tiles;
}

}  // namespace trace
