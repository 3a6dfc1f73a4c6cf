// Times of the same work done again and again.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

namespace trace::bench {

class Times {
 public:
  explicit Times(std::vector<double> milliseconds) : sorted_(std::move(milliseconds)) {
    std::sort(sorted_.begin(), sorted_.end());
  }

  // The upper one of the middle two where they are even in number.
  double median() const { return sorted_[sorted_.size() / 2]; }
  std::string text() const {
    return fmt::format("median_ms={:.4f} min_ms={:.4f} max_ms={:.4f}", median(), sorted_.front(),
                       sorted_.back());
  }

 private:
  std::vector<double> sorted_;
};

// Milliseconds that `work` takes. What it returns is destroyed outside of the time.
template <class Work>
double timed(Work&& work) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  [[maybe_unused]] const auto result = work();
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

// After a first time that fills the caches and is not counted, `repetitions` (at least 1) times.
template <class Work>
Times repeated(int repetitions, Work&& work) {
  timed(work);
  std::vector<double> milliseconds;
  for (int i = 0; i < repetitions; ++i) milliseconds.push_back(timed(work));
  return Times(std::move(milliseconds));
}

}  // namespace trace::bench
