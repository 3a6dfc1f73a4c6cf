// Ctrl-C and its like, asked for instead of suffered.
#pragma once

#include <signal.h>

namespace trace {

// While it lives SIGINT, SIGTERM and SIGHUP do not end this process; pending() tells which of them came. One
// that is ignored already (nohup) stays so.
class SignalWatch {
 public:
  SignalWatch() {
    sigemptyset(&watched_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      struct sigaction action {};
      sigaction(signal, nullptr, &action);
      if (action.sa_handler != SIG_IGN) sigaddset(&watched_, signal);
    }
    sigprocmask(SIG_BLOCK, &watched_, &before_);
  }
  // What came and was not asked for is forgotten.
  ~SignalWatch() {
    while (pending() != 0) continue;
    sigprocmask(SIG_SETMASK, &before_, nullptr);
  }
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  // The signal that came since the last call; 0 for none.
  int pending() const {
    const timespec now{};
    const int signal = sigtimedwait(&watched_, nullptr, &now);
    return signal > 0 ? signal : 0;
  }

 private:
  sigset_t watched_{}, before_{};
};

}  // namespace trace
