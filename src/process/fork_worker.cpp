#include "process/fork_worker.hpp"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <system_error>
#include <utility>

#include "process/child_setup.hpp"
#include "process/pidfd.hpp"
#include "process/pipe.hpp"
#include "process/sanitizers.hpp"

namespace trace {
namespace {

[[noreturn]] void fail(const char* what, int error = errno) {
  throw std::system_error(error, std::generic_category(), what);
}

// The whole life of the new process.
[[noreturn]] void be_worker(pid_t supervisor, const Descriptor& socket, Descriptor output, const Work& work,
                            const std::function<void()>& in_child) {
  try {
    die_with(supervisor, SIGKILL);
    default_signals(built_with_sanitizer);
    // These reach all of the group (Ctrl-C, a closed terminal, timeout(1)); what they mean, the supervisor
    // decides.
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
    no_core_file();
    in_child();
    no_standard_input();
    place_descriptor(output.get(), STDOUT_FILENO);
    place_descriptor(output.get(), STDERR_FILENO);
    output.reset();
    run_worker(socket.get(), work);
  } catch (...) {
    _exit(1);
  }
}

}  // namespace

ForkedWorker fork_worker(const Work& work, const std::function<void()>& in_child) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail("socketpair");
  ForkedWorker forked;
  forked.socket = above_standard(Descriptor(ends[0]));
  const Descriptor worker_socket = above_standard(Descriptor(ends[1]));
  Pipe errors;
  forked.errors = std::move(errors.read);

  std::cout.flush();  // else the worker would write the same once more
  std::fflush(nullptr);
  const pid_t supervisor = getpid();
  forked.pid = fork();
  if (forked.pid < 0) fail("fork");
  if (forked.pid == 0) {
    forked.socket.reset();
    forked.errors.reset();
    be_worker(supervisor, worker_socket, std::move(errors.write), work, in_child);
  }
  forked.process = Descriptor(pidfd_open(forked.pid, 0));
  if (!forked.process) {
    const int error = errno;
    kill(forked.pid, SIGKILL);
    waitpid(forked.pid, nullptr, 0);
    fail("pidfd_open", error);
  }
  must_not_block(forked.socket);
  must_not_block(forked.errors);
  return forked;
}

}  // namespace trace
