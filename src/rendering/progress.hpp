// How far a render is; written by the render, read by whoever shows it.
#pragma once

#include <atomic>
#include <cstdint>

namespace trace {

struct Progress {
  std::atomic<std::uint64_t> done = 0, total = 0;  // in pixels, refined ones counted again
};

}  // namespace trace
