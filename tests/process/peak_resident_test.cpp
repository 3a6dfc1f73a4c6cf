// The most memory that was resident.
#include "process/process_files.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <catch2/catch.hpp>

namespace trace::test {
namespace {

constexpr std::size_t mebibyte = std::size_t{1} << 20;

// Memory straight from the kernel, each page written to; it is given back at once when this ends.
class TouchedPages {
 public:
  explicit TouchedPages(std::size_t size)
      : size_(size), begin_(mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {
    if (begin_ == MAP_FAILED) return;
    for (std::size_t at = 0; at < size; at += 4096) static_cast<volatile char*>(begin_)[at] = 1;
  }
  TouchedPages(const TouchedPages&) = delete;
  TouchedPages& operator=(const TouchedPages&) = delete;
  ~TouchedPages() {
    if (begin_ != MAP_FAILED) munmap(begin_, size_);
  }
  bool there() const { return begin_ != MAP_FAILED; }

 private:
  std::size_t size_;
  void* begin_;
};

}  // namespace

TEST_CASE("memory that is touched shows in the peak, and is still in it when it has been given back") {
  const bool fresh = reset_peak_resident();
  const std::uint64_t before = peak_resident(getpid());
  REQUIRE(before > mebibyte);
  {
    // Beyond what an earlier peak may hide where it could not be forgotten.
    const TouchedPages pages((fresh ? 64 : 64 + before / mebibyte) * mebibyte);
    REQUIRE(pages.there());
    CHECK(peak_resident(getpid()) > before + 60 * mebibyte);
  }
  CHECK(peak_resident(getpid()) > before + 60 * mebibyte);
  if (reset_peak_resident()) CHECK(peak_resident(getpid()) < before + 32 * mebibyte);
}

}  // namespace trace::test
