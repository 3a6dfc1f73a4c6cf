#include "process/memory_watch.hpp"

#include <unistd.h>

#include <algorithm>
#include <vector>

#include "process/process_files.hpp"

namespace trace {
namespace {

// To keep a limit (some ten megabytes can be written to in that time), and just to know.
constexpr std::chrono::milliseconds limited_interval{5}, measured_interval{20};

}  // namespace

MemoryWatch::MemoryWatch(std::uint64_t limit_bytes)
    : limit_(limit_bytes), our_peak_(peak_resident(getpid())) {}

bool MemoryWatch::look(pid_t keeper, Clock::time_point now) {
  next_look_ = now + (limit_ > 0 ? limited_interval : measured_interval);
  const std::vector<pid_t> processes = descendants(keeper);
  std::uint64_t together = 0;
  for (pid_t process : processes) together += resident_memory(process).all;
  // A program that has just forked seems to have everything twice. Sharing out takes longer to find out.
  if (limit_ > 0 && together > limit_ && processes.size() > 1) {
    together = 0;
    for (pid_t process : processes) together += proportional_memory(process);
  }
  seen_ = std::max(seen_, together);
  return limit_ > 0 && together > limit_;
}

std::uint64_t MemoryWatch::peak(const rusage& of_all) const {
  // The kernel's figure counts from the fork on, when the process had our memory, so it means something only
  // where it is more than that.
  const std::uint64_t largest = std::uint64_t(of_all.ru_maxrss) * 1024;
  return std::max(seen_, largest > our_peak_ ? largest : 0);
}

}  // namespace trace
