// What to render of a scene.
#pragma once

#include "image/size_limits.hpp"
#include "instruction_set/instruction_set.hpp"
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

struct RenderOptions {
  int width = 512;
  int depth = 5;
  int threads = 0;  // 0: as many as the machine has
  InstructionSet instruction_set = best_instruction_set();
  ShadingOptions shading;
  Antialiasing antialiasing;
  BlockInterpolation blocks;
};

inline constexpr int max_width = max_side;
inline constexpr int max_supersamples = 64;
inline constexpr int max_block_size = 4096;

}  // namespace trace
