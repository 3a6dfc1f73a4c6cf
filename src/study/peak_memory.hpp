// The most memory this process has resident, as the kernel counts it.
#pragma once

#include <cstdint>

namespace trace {

// Starts the count afresh from what is resident now. False where the kernel does not let us
// (/proc/self/clear_refs).
bool forget_peak_memory();

// In bytes; 0 where it is not known.
std::uint64_t peak_memory();

}  // namespace trace
