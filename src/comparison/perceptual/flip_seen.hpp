// What FLIP's observer makes of a tile of one picture.
#pragma once

#include "comparison/perceptual/convolution.hpp"
#include "comparison/perceptual/flip_filters.hpp"
#include "comparison/perceptual/srgb.hpp"
#include "comparison/perceptual/tiles.hpp"
#include "image/raster.hpp"

namespace trace {

// Of the same size as the tile.
struct FlipSeen {
  Plane l, a, b;        // colour after the eye's filter, as HuntLab
  Plane edges, points;  // how strong the features are
};

struct FlipTools {
  FlipFilters filters = flip_filters();
  LinearOfLevel linear;
};

// Of tiles, reusing its memory from one to the next. Beyond its border the picture goes on with the colour of
// its nearest pixel.
class FlipObserver {
 public:
  void look(const FlipTools& tools, const Raster& raster, const Tile& tile, FlipSeen& seen);

 private:
  void load(const LinearOfLevel& linear, const Raster& raster, const Tile& surroundings);
  void filter(const Plane& in, const FlipFilters::Taps& taps, Plane& out);
  void see_colors(const FlipFilters& filters, FlipSeen& seen);
  void see_features(const FlipFilters& filters, FlipSeen& seen);

  Plane light_, red_green_, blue_yellow_;  // of the tile with color_radius around it
  Plane scratch_, cut_, second_, smooth_, edge_, point_;
};

}  // namespace trace
