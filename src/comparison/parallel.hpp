// Work cut into parts whose results do not depend on who does them.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace trace {

// Calls part(i, scratch) once for every i below `parts`, on at most `threads` threads (at least this one),
// each of which has a Scratch of its own. The first exception of any part is thrown again when all threads
// have ended.
template <typename Scratch, typename Part>
void in_parallel_with(std::size_t parts, unsigned threads, const Part& part) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      Scratch scratch;
      for (std::size_t i = next++; i < parts; i = next++) part(i, scratch);
    } catch (...) {
      if (!failed.exchange(true)) failure = std::current_exception();
      next = parts;
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < threads && i < parts; ++i) helpers.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

struct NoScratch {};

// The same for parts that need no memory of their own: part(i).
template <typename Part>
void in_parallel(std::size_t parts, unsigned threads, const Part& part) {
  in_parallel_with<NoScratch>(parts, threads, [&](std::size_t i, NoScratch&) { part(i); });
}

}  // namespace trace
