// A list of work divided between the threads of a budget.
#pragma once

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

}  // namespace trace
