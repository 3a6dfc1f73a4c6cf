// The settings that a study tries: a ladder for each axis.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "precision/arithmetic.hpp"
#include "rendering/options.hpp"
#include "study/axis.hpp"

namespace trace {

struct Setting {
  std::string name;  // "2x2", "adaptive 4", "depth 3": unique in a study
  Axis axis;
  std::string text;   // a clause that says what it is
  std::string flags;  // of `trace` beside -r, where they can say it
  RenderOptions options;
  double error_budget = 0;               // levels; above 0: the picture for so much error
  int divisor = 1;                       // of the width; the picture is enlarged to it again
  std::optional<Arithmetic> arithmetic;  // by the plain tracer in this kind of number
};

// The course's one sample a pixel: what others are compared with.
inline constexpr const char* base_setting = "1";

// What decides which ladders make sense for a scene.
struct LadderScene {
  RenderOptions options;    // of the base setting
  std::vector<int> depths;  // that change anything, ascending; only 0 where no ray has a successor
};

// Settings in the order of the axes and of growing effort; the base setting first.
std::vector<Setting> ladders(const LadderScene& scene, const std::vector<Axis>& axes);

}  // namespace trace
