// The command line of `trace batch`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "batch/scene_list.hpp"
#include "comparison/judge.hpp"
#include "rendering/options.hpp"

namespace trace {

struct BatchArguments {
  std::string folder, output, settings, cube_map, solutions, tolerances;
  std::string report, csv, junit;
  std::vector<std::string> programs;  // --exec, as given
  SceneFilter filter;
  RenderOptions options;
  std::optional<Tolerance> tolerance;  // where the command line gives any limit
  double timeout = 180;                // seconds
  std::optional<double> memory;        // MiB
  bool fresh = false, quiet = false, link_pictures = false;
  int workers = 1;
  std::string command;  // the whole command line, for the report
};

// The exit status where there is nothing more to do: help was asked for, or the command line is wrong, which
// was said.
std::optional<int> parse_batch_arguments(int argc, const char* const* argv, BatchArguments& arguments);

}  // namespace trace
