// `trace study SCENE... [options]`.
#pragma once

namespace trace {

// Messages and progress go to standard error, the outcome to standard output. The result is the program's
// exit status (exit_status.hpp). `argv` begins with "study".
int study_command(int argc, const char* const* argv);

}  // namespace trace
