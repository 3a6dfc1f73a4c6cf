// What a job or a program may use at most.
#pragma once

#include <chrono>
#include <cstdint>

namespace trace {

struct Limits {
  std::chrono::duration<double> timeout{0};  // of the wall clock; 0: none
  std::uint64_t memory_bytes = 0;            // 0: none
};

}  // namespace trace
