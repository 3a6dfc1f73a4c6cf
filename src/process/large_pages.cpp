#include "process/large_pages.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

namespace trace {

void use_large_pages(std::size_t reserve) {
  constexpr std::uintptr_t large_page = std::uintptr_t{2} << 20;
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_TOP_PAD, static_cast<int>(reserve));
  const auto begin = reinterpret_cast<std::uintptr_t>(sbrk(0));
  void* volatile grows_the_heap = std::malloc(large_page);  // volatile: or the compiler leaves both calls out
  std::free(grows_the_heap);
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0));
  const std::uintptr_t first = (begin + large_page - 1) / large_page * large_page;
  if (first < end) madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
}

}  // namespace trace
