// What the program's exit status says. Each command has its own table.
#pragma once

namespace trace {

// `trace scene.ray out.png`.
enum ExitStatus : int {
  exit_done = 0,
  exit_bad_input = 1,     // the scene, a texture or the settings file cannot be used
  exit_usage = 2,         // the command line cannot be used
  exit_cannot_write = 3,  // the picture cannot be written
};

// `trace diff A B`. The largest that applies. The first four are also exit_status(Verdict).
enum DiffStatus : int {
  diff_within = 0,  // all pictures are identical or within tolerance
  diff_beyond = 1,  // a picture is beyond tolerance, or holds NaN or infinity
  diff_shape = 2,   // sizes or numbers of channels differ
  diff_file = 3,    // a file is missing, extra, cannot be read or cannot be written
  diff_usage = 4,   // the command line cannot be used
};

// `trace batch DIR -o OUT`. The largest that applies; 128 + N where signal N interrupted it.
enum BatchExitStatus : int {
  batch_done = 0,    // all rendered, and identical or within tolerance
  batch_beyond = 1,  // some are not within tolerance
  batch_failed = 3,  // some were not rendered, or results cannot be written
  batch_usage = 4,   // the command line, batch.json or tolerances cannot be used
};

}  // namespace trace
