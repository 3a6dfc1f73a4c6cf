// What the kernel tells of a process through /proc. All figures are in bytes, 0 where the process is gone.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <vector>

namespace trace {

struct ResidentMemory {
  std::uint64_t all = 0;  // shared pages included
  std::uint64_t own = 0;  // without pages of files and of memory that is shared with other processes
};
ResidentMemory resident_memory(pid_t process);

// Resident, with each page shared out among the processes that have it; takes a millisecond or more. As
// resident_memory() where it may not be looked at.
std::uint64_t proportional_memory(pid_t process);

// The most that was resident since the process started its program or set the mark back.
std::uint64_t peak_resident(pid_t process);
// Sets that mark of this process back to what is resident now. False where that is refused: peaks are then of
// the whole life of the process.
bool reset_peak_resident();

// Private memory of this process that can be written, touched or not: what RLIMIT_DATA limits.
std::uint64_t data_size();

// Every process below this one.
std::vector<pid_t> descendants(pid_t process);

}  // namespace trace
