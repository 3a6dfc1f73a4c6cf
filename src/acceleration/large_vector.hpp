// Vectors for large arrays that are written once.
#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace trace {

// Asks the system for pages of 2 MiB, of which each is one page fault instead of 512, and for smaller memory
// for all of its pages at once. Where it refuses there are more page faults. Elements that no value is given
// for are not initialized.
template <class T>
class LargePages {
 public:
  using value_type = T;
  static constexpr std::size_t large_page = std::size_t{2} << 20;
  static constexpr std::size_t page = std::size_t{4} << 10;
  static constexpr std::size_t least = 16 * page;  // below, malloc() is likely to have pages at hand

  LargePages() = default;
  template <class U>
  explicit LargePages(const LargePages<U>&) {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    auto* const memory = static_cast<char*>(::operator new(bytes, alignment(bytes)));
    if (bytes >= least) {
      const std::size_t large = bytes / large_page * large_page;  // begins at a large page
      if (large > 0) madvise(memory, large, MADV_HUGEPAGE);
      const auto rest = (reinterpret_cast<std::uintptr_t>(memory) + large + page - 1) / page * page;
      const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / page * page;
      if (rest < end) madvise(reinterpret_cast<void*>(rest), end - rest, MADV_POPULATE_WRITE);
    }
    return reinterpret_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) { ::operator delete(memory, alignment(count * sizeof(T))); }

  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    if constexpr (sizeof...(Arguments) == 0) {
      static_assert(std::is_trivially_destructible_v<U>);
      ::new (static_cast<void*>(at)) U;
    } else {
      std::construct_at(at, std::forward<Arguments>(arguments)...);
    }
  }

  bool operator==(const LargePages&) const { return true; }

 private:
  static std::align_val_t alignment(std::size_t bytes) {
    return std::align_val_t{bytes >= large_page ? large_page : std::max(alignof(T), std::size_t{64})};
  }
};

template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace trace
