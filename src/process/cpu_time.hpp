// Processor time, user and system together, in seconds.
#pragma once

#include <sys/resource.h>
#include <sys/time.h>

namespace trace {

inline double cpu_seconds(const rusage& usage) {
  const auto seconds = [](const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Of this process and of those it started and waited for.
inline double cpu_seconds_so_far() {
  rusage self{}, children{};
  getrusage(RUSAGE_SELF, &self);
  getrusage(RUSAGE_CHILDREN, &children);
  return cpu_seconds(self) + cpu_seconds(children);
}

}  // namespace trace
