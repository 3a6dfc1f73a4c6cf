// What both forms of the program do with an exception that no command expected.
#pragma once

#include <cstdio>
#include <exception>
#include <new>

#include "tools/trace/exit_status.hpp"

namespace trace {

// The exit status that `command` returns; one that tells of bad input, after a message, where it throws.
template <typename Command>
int reported(Command command) {
  try {
    return command();
  } catch (const std::bad_alloc&) {
    std::fputs("trace: error: out of memory\n", stderr);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "trace: error: %s\n", e.what());
  }
  return exit_bad_input;
}

}  // namespace trace
