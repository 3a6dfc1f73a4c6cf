// A limit on the memory this process may allocate from now on.
//
// RLIMIT_DATA, not RLIMIT_AS: it counts private writable memory (heap, anonymous mappings, stacks of
// threads), which is what a runaway allocation grows. RLIMIT_AS also counts what costs nothing: mapped files
// and shared pictures, and the address space that allocators, garbage collectors and thread arenas reserve
// without using it, so that any value low enough to protect the machine stops harmless programs.
#pragma once

#include <sys/resource.h>

#include <cstdint>

namespace trace {

// While it lives: allocations fail beyond `bytes` more than the process uses when it is made. Does nothing
// for 0 and under sanitizers, whose shadow memory counts.
class DataLimit {
 public:
  explicit DataLimit(std::uint64_t bytes);
  DataLimit(const DataLimit&) = delete;
  DataLimit& operator=(const DataLimit&) = delete;
  ~DataLimit();

 private:
  bool set_ = false;
  rlimit before_{};
};

}  // namespace trace
