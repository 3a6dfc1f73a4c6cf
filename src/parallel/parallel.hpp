// Work shared between threads that live only as long as the work: starting one costs some 30 microseconds,
// less than waking a pool of them, and a program that needs none pays nothing.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace trace {

// As many as the machine runs at once; at least 1.
int hardware_threads();

// As many as wanted; where that is 0, as many as the machine runs at once.
inline int threads_or_all(int wanted) {
  return wanted > 0 ? wanted : hardware_threads();
}

// Calls work(thread) for 0 .. threads - 1 side by side, 0 on the caller's own thread, and returns when all
// have ended; the first exception of any of them is then thrown again. A thread that the system refuses is
// left out, so the work must not be divided by the number of threads.
void on_threads(int threads, const std::function<void(int thread)>& work);

// Calls body(index, scratch) once for every index below `count`, in any order, on at most `threads` threads
// (the caller's is one) and no more than there are indices; each has a Scratch, made by make(thread). An
// index goes to whichever thread is free. After an exception no more of them are given out; the first one is
// thrown again.
template <class Make, class Body>
void parallel_for_with(int threads, std::size_t count, Make&& make, Body&& body) {
  std::atomic<std::size_t> next{0};
  const int most = count < static_cast<std::size_t>(threads) ? static_cast<int>(count) : threads;
  on_threads(most, [&](int thread) {
    try {
      auto scratch = make(thread);
      for (std::size_t i = next++; i < count; i = next++) body(i, scratch);
    } catch (...) {
      next = count;
      throw;
    }
  });
}

// The same for a body(index, thread); thread is below `threads`, 0 is the caller's.
template <class Body>
void parallel_for(int threads, std::size_t count, Body&& body) {
  parallel_for_with(
      threads, count, [](int thread) { return thread; }, body);
}

// Threads for work that divides itself: within either part of both(), both() may be called again.
class ThreadBudget {
 public:
  // At most `threads` work at the same time, the caller's among them.
  explicit ThreadBudget(int threads) : spare_(threads - 1) {}
  ThreadBudget(const ThreadBudget&) = delete;
  ThreadBudget& operator=(const ThreadBudget&) = delete;

  // Calls a() and b(), side by side if a thread is to be had, and returns when both have ended. What either
  // throws is thrown again then; of two exceptions that of b.
  template <class A, class B>
  void both(A&& a, B&& b) {
    if (take()) {
      side_by_side(std::ref(a), std::ref(b));
    } else {
      a();
      b();
    }
  }

 private:
  bool take();
  void side_by_side(const std::function<void()>& a, const std::function<void()>& b);

  std::atomic<int> spare_;  // threads that may be started now
};

}  // namespace trace
