// A command line as a shell would take it.
#pragma once

#include <string>

namespace trace {

// "trace" and the words, quoted where they need it; `argv` begins with the command's name.
std::string command_line(int argc, const char* const* argv);

}  // namespace trace
