// One scene to be rendered by one renderer, and what is to be known of the result.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "comparison/judge.hpp"
#include "process/limits.hpp"
#include "rendering/options.hpp"

namespace trace {

// A column of the report: this program, or another that is run in its place.
struct Renderer {
  std::string name;
  std::vector<std::string> command;  // words with {depth}, {width}, {scene} and {out}; empty: this program
};

struct Job {
  std::string name;   // the scene's path below the batch's folder: "simple/box.ray"
  std::string scene;  // the file, as messages show it
  Renderer renderer;
  RenderOptions options;
  std::string cube_map;  // one of its faces; may be empty
  Limits limits;
  std::filesystem::path picture;   // where it goes
  std::filesystem::path solution;  // empty: nothing to compare with
  std::filesystem::path heat_map;  // empty: not wanted
  Tolerance tolerance;

  // Whether the file that is there now was drawn by an earlier run, so that it may go where there is no new
  // one.
  bool has_old_picture = false;
};

}  // namespace trace
