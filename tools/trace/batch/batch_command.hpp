// `trace batch DIR -o OUT [options]`.
#pragma once

namespace trace {

// Messages and progress go to standard error, the outcome in a few lines to standard output. The result is
// the program's exit status (exit_status.hpp), or 128 and the signal's number after an interruption. `argv`
// begins with "batch".
int batch_command(int argc, const char* const* argv);

}  // namespace trace
