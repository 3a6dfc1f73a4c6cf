// The command line of `trace study`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rendering/options.hpp"
#include "study/axis.hpp"

namespace trace {

struct StudyArguments {
  std::vector<std::string> scenes;  // files, and folders of them
  std::string solutions, settings, cube_map;
  std::string report, json, csv, svg;
  std::vector<Axis> axes;
  RenderOptions options;
  bool width_given = false, depth_given = false;
  double seconds = 2;
  bool quiet = false;
  std::string command;  // the whole command line, for the report
};

inline constexpr int study_width = 256;

// The exit status where there is nothing more to do: help was asked for, or the command line is wrong, which
// was said.
std::optional<int> parse_study_arguments(int argc, const char* const* argv, StudyArguments& arguments);

}  // namespace trace
