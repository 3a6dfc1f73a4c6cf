// Work done side by side by a bounded number of threads.
#pragma once

#include <atomic>
#include <future>

namespace trace {

// What is computed must not depend on which thread does it: then it does not depend on their number.
class SpareThreads {
 public:
  // Besides the caller's own, so for n threads in all n - 1.
  explicit SpareThreads(unsigned count) : spare_(static_cast<int>(count)) {}

  // Both have been called on return; at the same time if a thread is to spare.
  template <class First, class Second>
  void both(First&& first, Second&& second) {
    if (spare_.fetch_sub(1, std::memory_order_relaxed) > 0) {
      std::future<void> other = std::async(std::launch::async, [&] {
        first();
        spare_.fetch_add(1, std::memory_order_relaxed);
      });
      second();
      other.get();
    } else {
      spare_.fetch_add(1, std::memory_order_relaxed);
      first();
      second();
    }
  }

  // work(i) for each i in [first, last).
  template <class Work>
  void each(std::size_t first, std::size_t last, const Work& work) {
    if (last - first < 2) {
      if (first < last) work(first);
      return;
    }
    const std::size_t middle = first + (last - first) / 2;
    both([&] { each(first, middle, work); }, [&] { each(middle, last, work); });
  }

 private:
  std::atomic<int> spare_;
};

}  // namespace trace
