// What to render of a scene.
#pragma once

#include "image/size_limits.hpp"
#include "instruction_set/instruction_set.hpp"
#include "parser/description.hpp"
#include "shading/options.hpp"
#include "shading/whitted.hpp"

namespace trace {

struct Antialiasing {
  bool enabled = false;
  int supersamples = 3;    // samples a pixel along each axis
  double threshold = 100;  // thousandths; neighbours that differ by more are refined
};

struct BlockInterpolation {
  double threshold = 0;  // thousandths; 0 traces every pixel
  int size = 4;          // edge of a block in pixels
};

// Samples in every pixel, which is the rectangle from the corner where the course samples it to that of the
// next: ours, instead of the course's antialiasing and blocks.
struct Sampling {
  int grid = 1;              // n x n; 1: the course's one sample, at the corner
  double threshold = 0;      // above 0: adaptive, to an error of about so many levels in a pixel on an edge
  int most = 16;             // n x n at most where adaptive
  bool nine_points = false;  // corners, middles of edges and centre of each pixel, instead of a grid
};

struct RenderOptions {
  // How the scene is read (loading/scene_loader.hpp).
  parser::Dialect dialect = parser::Dialect::utexas;
  bool permissive = false;
  int width = 512;
  int depth = 5;
  int threads = 0;  // 0: as many as the machine has
  InstructionSet instruction_set = best_instruction_set();
  ShadingOptions shading;
  Antialiasing antialiasing;
  BlockInterpolation blocks;
  Sampling sampling;
  bool keep_colors = false;  // the result holds the colours before they are cut to bytes too
};

inline constexpr int max_width = max_side;
inline constexpr int max_supersamples = 64;
inline constexpr int max_block_size = 4096;
inline constexpr int max_grid = 64;
inline constexpr double least_threshold = 0.01;  // levels, of Sampling

}  // namespace trace
