// The diagnosis of two pictures as text, and the scenes that most tests use.
#pragma once

#include <stdexcept>
#include <string>

#include "comparison/diagnosis/diagnosis.hpp"
#include "comparison/measure.hpp"
#include "tests/diagnosis/defects.hpp"
#include "tests/support/temporary_folder.hpp"

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

// The same with a part of its text replaced. Throws where the part is not in it.
inline Scene our_scene_with(const std::string& name, const std::string& part, const std::string& instead) {
  std::string text = read_text(std::string(TRACE_SOURCE_DIR "/scenes/") + name + ".ray");
  const std::size_t at = text.find(part);
  if (at == std::string::npos) throw std::runtime_error("not in " + name + ": " + part);
  return scene_of_text(text.replace(at, part.size(), instead));
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

// Where the solution is of another size or has settings.
inline Raster our_picture(const std::string& name) {
  return picture(our_scene(name), right_way());
}

}  // namespace trace::test
