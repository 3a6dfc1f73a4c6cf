#include "parallel/parallel.hpp"

#include <algorithm>
#include <deque>
#include <exception>
#include <optional>
#include <system_error>
#include <thread>

#include "parallel/thread_elsewhere.hpp"

namespace trace {

int hardware_threads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void on_threads(int threads, const std::function<void(int thread)>& work) {
  if (threads <= 1) return work(0);
  std::atomic<bool> failed{false};
  std::exception_ptr failure;
  const auto guarded = [&](int thread) {
    try {
      work(thread);
    } catch (...) {
      if (!failed.exchange(true)) failure = std::current_exception();
    }
  };
  {
    std::deque<ThreadElsewhere> helpers;
    try {
      for (int thread = 1; thread < threads; ++thread) {
        helpers.emplace_back([&guarded, thread] { guarded(thread); }, thread - 1);
      }
    } catch (const std::system_error&) {
      // No more threads than these.
    }
    guarded(0);
  }
  if (failure) std::rethrow_exception(failure);
}

bool ThreadBudget::take() {
  int spare = spare_.load(std::memory_order_relaxed);
  while (spare > 0) {
    if (spare_.compare_exchange_weak(spare, spare - 1)) return true;
  }
  return false;
}

void ThreadBudget::side_by_side(const std::function<void()>& a, const std::function<void()>& b) {
  // Whoever ends first leaves his place to the parts of the other; the other's is the caller's afterwards.
  std::atomic<int> ended{0};
  const auto end = [&] {
    if (ended++ == 0) ++spare_;
  };
  std::exception_ptr failure_of_a, failure_of_b;
  const auto guarded = [&end](const std::function<void()>& part, std::exception_ptr& failure) {
    try {
      part();
    } catch (...) {
      failure = std::current_exception();
    }
    end();
  };
  {
    std::optional<ThreadElsewhere> helper;
    try {
      helper.emplace([&] { guarded(a, failure_of_a); });
    } catch (const std::system_error&) {
      guarded(a, failure_of_a);
    }
    guarded(b, failure_of_b);
  }
  if (failure_of_b) std::rethrow_exception(failure_of_b);
  if (failure_of_a) std::rethrow_exception(failure_of_a);
}

}  // namespace trace
