// Fewer page faults for a short-lived process that works on large arrays.
#pragma once

#include <cstddef>

namespace trace {

// What is allocated from now on comes from one heap, which keeps what is freed and, where the system allows,
// lies in large pages: one fault for 2 MiB instead of 512. The first `reserve` bytes of it are asked for at
// once, which takes address space but no memory. To be called before there are other threads.
void use_large_pages(std::size_t reserve);

}  // namespace trace
