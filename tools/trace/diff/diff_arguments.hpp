// The command line of `trace diff`.
#pragma once

#include <optional>
#include <string>

#include "comparison/judge.hpp"

namespace trace {

struct DiffArguments {
  std::string reference, test;
  std::optional<Tolerance> tolerance;  // where the command line gives any limit; then it is the only one
  std::string tolerances;              // the file to use instead of the reference folder's; may be empty
  bool update = false;
  std::string reason;
  std::string heat_map;  // a picture, or a folder of them; may be empty
  double amplify = 1;
  std::string json, csv, junit;  // files; "-" is standard output
  bool perceptual = true;
  bool quiet = false;
};

// Where the command line cannot be used, or asks for help only, `status` is set and what is to be said has
// been said.
struct ParsedDiff {
  DiffArguments arguments;
  std::optional<int> status;
};

// argv[0] is the command's own name, "diff".
ParsedDiff parse_diff(int argc, const char* const* argv);

// Standard error: "trace: error: TEXT" and where help is. Returns the exit status.
int diff_usage_error(const std::string& text);

}  // namespace trace
