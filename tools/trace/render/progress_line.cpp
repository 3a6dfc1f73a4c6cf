#include "tools/trace/render/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>

namespace trace {

using namespace std::chrono_literals;

ProgressLine::ProgressLine(const Progress& progress, bool wanted) : progress_(progress) {
  if (wanted && isatty(STDERR_FILENO)) thread_ = std::thread([this] { show(); });
}

ProgressLine::~ProgressLine() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  stop_.notify_one();
  thread_.join();
}

void ProgressLine::show() {
  const auto begin = std::chrono::steady_clock::now();
  bool shown = false;
  std::unique_lock lock(mutex_);
  auto wait = 1000ms;
  while (!stop_.wait_for(lock, wait, [this] { return stopping_; })) {
    wait = 200ms;
    const auto done = static_cast<double>(progress_.done), total = static_cast<double>(progress_.total);
    if (!(total > 0)) continue;
    const double share = done / total;
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    const double left = share > 0 ? spent.count() * (1 - share) / share : 0;
    fmt::print(stderr, "\r\033[K{:3.0f} %, {:.0f} s, about {:.0f} s left", 100 * share, spent.count(), left);
    std::fflush(stderr);
    shown = true;
  }
  if (shown) {
    fmt::print(stderr, "\r\033[K");
    std::fflush(stderr);
  }
}

}  // namespace trace
