// Pipes, and reading what is in them without waiting.
#pragma once

#include "process/bounded_text.hpp"
#include "process/descriptor.hpp"

namespace trace {

// Both ends are closed on exec. Throws std::system_error.
struct Pipe {
  Pipe();
  Descriptor read, write;
};

// Reading or writing fails with EAGAIN instead of waiting.
void must_not_block(const Descriptor& descriptor);

// Takes what is in the pipe now; closes it at its end. Not more than a few hundred kilobytes at a time:
// whoever never stops writing must not hold the reader. More than a pipe holds, though: all that was written
// by those that have ended.
void read_some(Descriptor& from, BoundedText& to);

}  // namespace trace
