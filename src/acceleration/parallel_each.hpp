// A list of work divided between the threads of a budget.
#pragma once

#include <algorithm>
#include <cstddef>

#include "parallel/parallel.hpp"

namespace trace {

// work(i) for each i in [first, last), the two halves by both(), and so on.
template <class Work>
void parallel_each(ThreadBudget& threads, std::size_t first, std::size_t last, const Work& work) {
  if (last - first < 2) {
    if (first < last) work(first);
    return;
  }
  const std::size_t middle = first + (last - first) / 2;
  threads.both([&] { parallel_each(threads, first, middle, work); },
               [&] { parallel_each(threads, middle, last, work); });
}

// work(first, last) for runs of about `size` that make up [0, count), divided likewise.
template <class Work>
void parallel_runs(ThreadBudget& threads, std::size_t count, std::size_t size, const Work& work) {
  parallel_each(threads, 0, (count + size - 1) / size,
                [&](std::size_t run) { work(run * size, std::min(count, (run + 1) * size)); });
}

}  // namespace trace
