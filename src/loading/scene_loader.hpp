// From a file's name to a scene ready to render, or to the messages that say why not.
#pragma once

#include <optional>
#include <string>

#include "image/image_source.hpp"
#include "parser/source.hpp"
#include "rendering/options.hpp"
#include "scene/scene.hpp"

namespace trace {

// What the parts of loading took, in milliseconds.
struct LoadTimes {
  double read = 0;   // opening and mapping the file
  double parse = 0;  // from text to description
  double build = 0;  // from description to scene
};

// And how many bytes they made.
struct LoadSizes {
  std::size_t text = 0;
  std::size_t description = 0;  // bytes_of(parser::Scene)
};

struct LoadedScene {
  std::optional<Scene> scene;  // empty where there are errors
  std::string messages;        // errors and warnings with their places; may be empty
  LoadTimes times{};
  LoadSizes sizes{};
};

struct LoadOptions {
  int width;
  parser::Dialect dialect = parser::Dialect::utexas;
  // Unknown words and files that cannot be read are warned of and left out (parser/parse.hpp).
  bool permissive = false;

  LoadOptions(int picture_width) : width(picture_width) {}
  LoadOptions(const RenderOptions& options)
      : width(options.width), dialect(options.dialect), permissive(options.permissive) {}
};

// `width` is that of the picture, whose height the scene decides and which may be out of bounds.
LoadedScene load_scene(const parser::Source& source, const LoadOptions& options, ImageSource& images);

// The same from a file; "-" is standard input.
LoadedScene load_scene(const std::string& file, const LoadOptions& options, ImageSource& images);

// Surrounds the scene with the six faces beside this one (scene/cube_map.hpp); "" is none. Where they cannot
// be had the result is the warning, with its line end, and the scene has no surroundings.
std::string add_cube_map(Scene& scene, const std::string& one_face, ImageSource& images);

}  // namespace trace
