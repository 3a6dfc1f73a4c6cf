// Runs another program (a student's renderer) under limits, whatever it does.
//
// No shell; standard input is empty; no core file. It is in a process group of its own and does not see the
// terminal's signals. Whatever it started has ended when run_program() returns, and when this process ends.
//
// Costs 1.5 ms for a small process, and some 0.1 ms more for each megabyte that ours has written to: it is
// forked.
//
// The memory limit is kept in two ways. RLIMIT_DATA (see data_limit.hpp for why not RLIMIT_AS) lets an
// allocation fail in a process that asks for too much; what all processes of the program have resident is
// looked at every few milliseconds, and they are killed when it is too much together. A program built with
// AddressSanitizer cannot run under a memory limit: its shadow memory counts as data.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "process/limits.hpp"
#include "process/outcome.hpp"

namespace trace {

struct ProgramOptions {
  Limits limits;
  std::filesystem::path folder;          // that it runs in; empty: ours
  std::vector<std::string> environment;  // "NAME=value", beside ours or instead
  bool errors_apart = false;             // from the output
  // Whether allocations beyond the memory limit fail (RLIMIT_DATA). Without, the program is only stopped once
  // it has that much resident: for programs that reserve more than they use, as with AddressSanitizer.
  bool refuse_allocations = true;
  std::uint64_t largest_file = std::uint64_t{1} << 30;  // bytes it may write to one file; 0: any number
};

struct ProgramResult {
  Outcome outcome;
  bool succeeded() const { return outcome == Outcome{Outcome::Kind::exited, 0}; }
  std::string output;  // bounded: see bounded_text.hpp
  std::string errors;  // where they are kept apart
  double seconds = 0;
  double cpu_seconds = 0;  // of all its processes
  std::uint64_t peak_memory_bytes =
      0;  // of all its processes together as far as it was seen, at least of the largest
};

// `arguments` begins with the program: a path, from our working folder where it is relative, or a name to be
// found in PATH. Throws std::system_error where the system has no processes or descriptors left,
// std::invalid_argument without arguments; that the program cannot be started is an outcome.
ProgramResult run_program(const std::vector<std::string>& arguments, const ProgramOptions& options = {});

}  // namespace trace
