// A list of work divided between the threads of a budget.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

#include "parallel/parallel.hpp"

namespace trace {

namespace detail {

// Up to 2^levels callers of `take_turns`, which takes work until none is left, as long as there is any.
template <class IsLeft, class TakeTurns>
void share(ThreadBudget& threads, int levels, const IsLeft& is_left, const TakeTurns& take_turns) {
  if (!is_left()) return;
  if (levels == 0) return take_turns();
  threads.both([&] { share(threads, levels - 1, is_left, take_turns); },
               [&] { share(threads, levels - 1, is_left, take_turns); });
}

}  // namespace detail

// work(i) for each i below `count`, in any order, the next one for whichever thread is free. No more threads
// are started than the budget has at the time, and none for a single piece of work.
template <class Work>
void parallel_each(ThreadBudget& threads, std::size_t count, const Work& work) {
  constexpr int most_levels = 8;
  int levels = 0;
  while (levels < most_levels && std::size_t{1} << levels < count) ++levels;
  std::atomic<std::size_t> next{0};
  detail::share(
      threads, levels, [&] { return next < count; },
      [&] {
        for (std::size_t i = next++; i < count; i = next++) work(i);
      });
}

// work(first, last) for runs of `size`, the last one shorter, that make up [0, count), likewise.
template <class Work>
void parallel_runs(ThreadBudget& threads, std::size_t count, std::size_t size, const Work& work) {
  parallel_each(threads, (count + size - 1) / size,
                [&](std::size_t run) { work(run * size, std::min(count, (run + 1) * size)); });
}

}  // namespace trace
