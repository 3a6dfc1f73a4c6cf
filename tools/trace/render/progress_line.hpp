// One line on a terminal for renders that take more than a second.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include "rendering/progress.hpp"

namespace trace {

// Shows share done and time left on standard error while it lives, if that is a terminal; then clears the
// line.
class ProgressLine {
 public:
  ProgressLine(const Progress& progress, bool wanted);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

 private:
  void show();

  const Progress& progress_;
  std::mutex mutex_;
  std::condition_variable stop_;
  bool stopping_ = false;
  std::thread thread_;  // not started where nothing is shown
};

}  // namespace trace
