// How much memory a program and all it started have resident together, looked at every few milliseconds.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <chrono>
#include <cstdint>

namespace trace {

class MemoryWatch {
 public:
  using Clock = std::chrono::steady_clock;

  explicit MemoryWatch(std::uint64_t limit_bytes);  // 0: none

  Clock::time_point next_look() const { return next_look_; }
  // Whether the processes below `keeper` are over the limit. Pages they share count once for each of them,
  // except where that would be over it.
  bool look(pid_t keeper, Clock::time_point now);

  // The most that was seen, but at least what the kernel says of the largest of these processes.
  std::uint64_t peak(const rusage& of_all) const;

 private:
  std::uint64_t limit_;
  std::uint64_t our_peak_;  // when the program was started
  std::uint64_t seen_ = 0;
  Clock::time_point next_look_;
};

}  // namespace trace
