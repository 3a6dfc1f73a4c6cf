// The diagnosis of two pictures as text, and the scenes that most tests use.
#pragma once

#include <functional>
#include <string>

#include "comparison/diagnosis.hpp"
#include "comparison/measure.hpp"
#include "tests/diagnosis/defects.hpp"

namespace trace::test {

// "shifted: shifted by 1 pixel to the right", or "nothing".
inline std::string diagnosed(const Raster& reference, const Raster& test) {
  MeasureOptions options;
  options.ssim = options.flip = false;
  const auto found = diagnose(reference, test, measure(reference, test, options));
  return found ? std::string(name(found->kind)) + ": " + found->text : "nothing";
}

// A scene of ours by its name below scenes/, without the extension.
inline Scene our_scene(const std::string& name) {
  return scene_of(std::string(TRACE_SOURCE_DIR "/scenes/") + name + ".ray");
}

inline Raster our_solution(const std::string& name) {
  return read_raster(std::string(TRACE_SOURCE_DIR "/scenes/solutions/") + name + ".png");
}

// As the solutions are drawn: 256 pixels wide, depth 5.
inline Way right_way() {
  Way way;
  way.options.width = 256;
  return way;
}

}  // namespace trace::test
