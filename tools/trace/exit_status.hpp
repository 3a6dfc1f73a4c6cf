// What the program's exit status says.
#pragma once

namespace trace {

enum ExitStatus : int {
  exit_done = 0,
  exit_bad_input = 1,     // the scene, a texture or the settings file cannot be used
  exit_usage = 2,         // the command line cannot be used
  exit_cannot_write = 3,  // the picture cannot be written
};

}  // namespace trace
