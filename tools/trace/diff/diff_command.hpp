// `trace diff [options] A B`: docs/diff.md.
#pragma once

namespace trace {

// argv[0] is "diff". Results go to standard output, errors to standard error; the result is the program's
// exit status (DiffStatus in exit_status.hpp). Throws nothing but what a lack of memory throws.
int diff_command(int argc, const char* const* argv);

}  // namespace trace
