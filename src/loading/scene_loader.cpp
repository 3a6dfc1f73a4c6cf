#include "loading/scene_loader.hpp"

#include <fmt/format.h>

#include <chrono>
#include <stdexcept>
#include <utility>

#include "loading/description_bytes.hpp"
#include "parser/parse.hpp"
#include "rendering/render.hpp"
#include "scene/build.hpp"

namespace trace {
namespace {

// The place that decides the picture's shape: the last aspectratio of the file.
parser::Span aspect_span(const parser::Scene& description) {
  parser::Span span;
  for (const parser::Item& item : description.items) {
    const auto* camera = std::get_if<parser::Camera>(&item);
    if (camera && camera->aspectratio) span = camera->aspectratio->span;
  }
  return span;
}

void check_size(const Scene& scene, int width, parser::Span span, parser::Diagnostics& diagnostics) {
  const double height = picture_height(scene, width);
  if (!(height >= 1)) {
    diagnostics.error(span,
                      fmt::format("a picture {} pixels wide would have no rows at this aspect ratio", width));
  } else if (!(height <= max_side && height * width <= max_pixels)) {
    diagnostics.error(
        span, fmt::format("a picture {} pixels wide would be {:.0f} pixels high at this aspect ratio; "
                          "the limits are {} pixels a side and {} in all",
                          width, height, max_side, max_pixels));
  }
}

class Stopwatch {
 public:
  // Milliseconds since the last call or since construction.
  double lap() {
    const Clock::time_point now = Clock::now();
    return std::chrono::duration<double, std::milli>(now - std::exchange(last_, now)).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

}  // namespace

LoadedScene load_scene(const parser::Source& source, const LoadOptions& options, ImageSource& images) {
  LoadedScene result;
  Stopwatch watch;
  parser::Diagnostics diagnostics;
  parser::Scene description = parser::parse(source, diagnostics, {options.dialect, options.permissive});
  source.release_memory();  // only messages need it now
  result.times.parse = watch.lap();
  result.sizes = {source.text().size(), bytes_of(description)};
  if (!diagnostics.has_errors()) {
    const parser::Span span = aspect_span(description);
    result.scene = build_scene(std::move(description), source, images, diagnostics);
    check_size(*result.scene, options.width, span, diagnostics);
  }
  if (diagnostics.has_errors()) result.scene.reset();
  result.messages = parser::render(source, diagnostics);
  result.times.build = watch.lap();
  return result;
}

LoadedScene load_scene(const std::string& file, const LoadOptions& options, ImageSource& images) {
  Stopwatch watch;
  std::optional<parser::Source> source;
  try {
    source = parser::Source::from_file(file);
  } catch (const std::runtime_error& e) {
    return {std::nullopt, fmt::format("trace: error: {}\n", e.what()), {}, {}};
  }
  const double read = watch.lap();
  LoadedScene result = load_scene(*source, options, images);
  result.times.read = read;
  return result;
}

std::string add_cube_map(Scene& scene, const std::string& one_face, ImageSource& images) {
  if (one_face.empty()) return "";
  std::string problem;
  scene.cube_map = read_cube_map(one_face, images, problem);
  return scene.cube_map ? "" : fmt::format("trace: warning: no cube map: {}\n", problem);
}

}  // namespace trace
