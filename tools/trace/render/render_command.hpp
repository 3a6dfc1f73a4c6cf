// `trace [options] scene.ray out.png`.
#pragma once

namespace trace {

// Messages go to standard error; the result is the program's exit status (exit_status.hpp). Nothing is
// written unless it is exit_done.
int render_command(int argc, const char* const* argv);

}  // namespace trace
