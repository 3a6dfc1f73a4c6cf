#include "process/child_setup.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>

namespace trace {

void die_with(pid_t parent, int signal) {
  prctl(PR_SET_PDEATHSIG, signal);
  if (getppid() != parent) _exit(1);
}

void default_signals(bool keep_crashes) {
  for (int signal = 1; signal < NSIG; ++signal) {
    const bool crash = signal == SIGSEGV || signal == SIGBUS || signal == SIGFPE || signal == SIGILL ||
                       signal == SIGABRT || signal == SIGTRAP;
    if (!crash || !keep_crashes) std::signal(signal, SIG_DFL);  // refused for SIGKILL and SIGSTOP
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

void no_core_file() {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
}

void place_descriptor(int descriptor, int number) {
  if (descriptor == number)
    fcntl(descriptor, F_SETFD, 0);
  else
    dup2(descriptor, number);
}

void no_standard_input() {
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nothing < 0) return;
  place_descriptor(nothing, STDIN_FILENO);
  if (nothing > STDERR_FILENO) close(nothing);
}

}  // namespace trace
