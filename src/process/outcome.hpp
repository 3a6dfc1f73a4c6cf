// How a job or a program ended.
#pragma once

#include <string>

namespace trace {

struct Outcome {
  enum class Kind {
    answered,        // a job that returned
    exited,          // `number` is the exit status
    signalled,       // `number` is the signal that ended it
    timed_out,       // killed at its limit
    out_of_memory,   // killed at its limit, or its own allocation failed there
    could_not_start  // `number` is the errno value; of programs only
  };
  Kind kind = Kind::answered;
  int number = 0;

  bool operator==(const Outcome&) const = default;
};

// "crashed (segmentation fault)", "exited with status 3", "ran out of time", "could not be started:
// permission denied".
std::string text(const Outcome& outcome);

// From what waitpid() tells.
Outcome outcome_of_status(int wait_status);

// Whether what a program or a job wrote before it ended says that an allocation failed: under a memory limit
// a C++ program that does not expect this aborts with the text of std::bad_alloc, a Python one exits with
// MemoryError, a GNU one says "memory exhausted". There is no other trace of it: the kernel does not tell
// which request it refused.
bool speaks_of_memory(const std::string& errors);

}  // namespace trace
