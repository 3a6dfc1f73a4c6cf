// The process between run_program() and the program: it ends with us, and leaves nothing of the program
// behind.
//
// A program is killed with its parent (PR_SET_PDEATHSIG), but what it started itself is not, and a process
// that was killed cannot clean up. The keeper can: it gets SIGTERM when its parent ends for whatever reason,
// or from its parent when a limit is passed; it is where orphans among the program's processes are handed to
// (PR_SET_CHILD_SUBREAPER), so that even those that left the process group are found; and the figures of all
// of them end up with it. It kills what is left also when the program has ended by itself.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <cstdint>

namespace trace {

// Prepared before the fork, since nothing may be allocated behind it.
struct ProgramStart {
  const char* file = nullptr;  // looked for in PATH where it has no slash
  char* const* arguments = nullptr;
  char* const* environment = nullptr;
  const char* folder = nullptr;    // null: where we are
  std::uint64_t memory_bytes = 0;  // 0: no limit
  std::uint64_t largest_file = 0;  // 0: no limit
  int output = -1, errors = -1;    // become its standard output and error
  int failure = -1;  // gets the errno value where the program cannot be started; closed if it can
  int report = -1;   // gets a KeeperReport at the end
};

struct KeeperReport {
  int status = 0;  // of the program, as waitpid() has it
  rusage usage{};  // of all its processes
};

// The keeper's life, in a process just forked from `parent`.
[[noreturn]] void keep_program(const ProgramStart& start, pid_t parent);

}  // namespace trace
