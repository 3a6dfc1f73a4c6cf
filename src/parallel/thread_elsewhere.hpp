// A thread that starts at once on another processor.
//
// Left to itself a new thread may be put behind its maker on the same processor, and be moved to an idle one
// only at the next tick of the system's clock, up to 4 ms later: longer than a small picture takes.
#pragma once

#include <pthread.h>
#include <sched.h>

#include <functional>

namespace trace {

class ThreadElsewhere {
 public:
  // Runs `work`, which must not throw. The `turn`-th of several threads starts on the `turn`-th other
  // processor; from then on it may run on all that its maker may. Throws std::system_error where the system
  // refuses.
  explicit ThreadElsewhere(std::function<void()> work, int turn = 0);
  ThreadElsewhere(const ThreadElsewhere&) = delete;
  ThreadElsewhere& operator=(const ThreadElsewhere&) = delete;
  // Waits for its end.
  ~ThreadElsewhere();

 private:
  static void* run(void* self);

  std::function<void()> work_;
  cpu_set_t allowed_;  // processors of the maker
  pthread_t thread_;
};

}  // namespace trace
