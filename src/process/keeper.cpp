#include "process/keeper.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <ctime>

#include "process/child_setup.hpp"

namespace trace {
namespace {

void limit(__rlimit_resource resource, std::uint64_t bytes) {
  rlimit value{};
  getrlimit(resource, &value);
  // Without a limit of its own the program is not to have the one of the job that starts it.
  value.rlim_cur = bytes > 0 && bytes < value.rlim_max ? bytes : value.rlim_max;
  value.rlim_max = value.rlim_cur;
  setrlimit(resource, &value);
}

[[noreturn]] void become_program(const ProgramStart& start, pid_t keeper) {
  setpgid(0, 0);
  die_with(keeper, SIGKILL);
  default_signals();
  no_standard_input();
  place_descriptor(start.output, STDOUT_FILENO);
  place_descriptor(start.errors, STDERR_FILENO);
  close_range(STDERR_FILENO + 1, ~0U, CLOSE_RANGE_CLOEXEC);
  no_core_file();
  limit(RLIMIT_DATA, start.memory_bytes);
  limit(RLIMIT_FSIZE, start.largest_file);
  if (start.folder == nullptr || chdir(start.folder) == 0)
    execvpe(start.file, start.arguments, start.environment);
  const int error = errno;
  const ssize_t told = write(start.failure, &error, sizeof error);
  _exit(told == sizeof error ? 127 : 126);
}

// The kernel's list of the keeper's children: numbers with blanks between.
void kill_children() {
  const int list = open("/proc/thread-self/children", O_RDONLY | O_CLOEXEC);
  if (list < 0) return;
  pid_t child = 0;
  char part[1024];
  for (ssize_t count; (count = read(list, part, sizeof part)) > 0;) {
    for (ssize_t i = 0; i < count; ++i) {
      if (part[i] >= '0' && part[i] <= '9') {
        child = child * 10 + (part[i] - '0');
      } else {
        if (child > 0) kill(child, SIGKILL);
        child = 0;
      }
    }
  }
  close(list);
}

// Kills and reaps until nothing is left: those whose parent was killed become children of this process. Gives
// up on what cannot be killed (waiting for a dead disk, say) after some seconds.
int end_all(pid_t program) {
  sigset_t child_ended;
  sigemptyset(&child_ended);
  sigaddset(&child_ended, SIGCHLD);
  int program_status = SIGKILL;
  kill(-program, SIGKILL);
  for (int round = 0; round < 500; ++round) {
    kill_children();
    int status = 0;
    pid_t ended = 0;
    while ((ended = waitpid(-1, &status, WNOHANG)) > 0) {
      if (ended == program) program_status = status;
    }
    if (ended < 0 && errno == ECHILD) break;
    const timespec pause{0, 10'000'000};
    sigtimedwait(&child_ended, nullptr, &pause);
  }
  return program_status;
}

// True once the program has ended; it stays a zombie, so that its number keeps standing for its group.
bool has_ended(pid_t program) {
  siginfo_t info{};
  return waitid(P_PID, id_t(program), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == program;
}

}  // namespace

void keep_program(const ProgramStart& start, pid_t parent) {
  default_signals();
  sigset_t awaited, all;
  sigemptyset(&awaited);
  sigaddset(&awaited, SIGCHLD);
  sigaddset(&awaited, SIGTERM);
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, nullptr);
  die_with(parent, SIGTERM);
  setsid();  // out of reach of the terminal's signals
  prctl(PR_SET_CHILD_SUBREAPER, 1);

  const pid_t keeper = getpid();
  const pid_t program = fork();
  if (program == 0) become_program(start, keeper);
  if (program < 0) {
    const int error = errno;
    const ssize_t told = write(start.failure, &error, sizeof error);
    _exit(told == sizeof error ? 127 : 126);
  }
  setpgid(program, program);  // whoever comes first
  close(start.output);
  if (start.errors != start.output) close(start.errors);
  close(start.failure);
  if (start.report > 0) close_range(0, unsigned(start.report) - 1, 0);
  close_range(unsigned(start.report) + 1, ~0U, 0);

  while (!has_ended(program) && sigwaitinfo(&awaited, nullptr) != SIGTERM) {
  }
  KeeperReport report;
  report.status = end_all(program);
  getrusage(RUSAGE_CHILDREN, &report.usage);
  _exit(write(start.report, &report, sizeof report) == sizeof report ? 0 : 1);
}

}  // namespace trace
