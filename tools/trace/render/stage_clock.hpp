// How long the stages of a run take.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>

namespace trace {

enum class Stage { start, load, build, render, write };

class StageClock {
 public:
  // Ends a stage: the time since the last call, or since construction, is that stage's.
  void lap(Stage stage) {
    const Clock::time_point now = Clock::now();
    milliseconds_[static_cast<std::size_t>(stage)] =
        std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
  }

  // Since construction.
  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

  // 0 for one that has not ended.
  double milliseconds(Stage stage) const { return milliseconds_[static_cast<std::size_t>(stage)]; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now(), last_ = begin_;
  std::array<double, 5> milliseconds_{};
};

}  // namespace trace
