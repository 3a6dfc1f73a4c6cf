// Whole processes, started by as little as can be: the shells and interpreters that usually do it take longer
// than what is measured here.
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <iostream>
#include <sstream>
#include <stdexcept>

#include "tools/benchmark/kernels/repeated.hpp"
#include "tools/benchmark/kernels/stages.hpp"

namespace trace::bench {
namespace {

using Words = std::vector<std::string>;

struct Run {
  double wall_ms, user_ms, system_ms;
  long peak_kilobytes;  // resident
  int status;           // of exit; 128 and more for a signal
};

// Its output goes nowhere.
class Command {
 public:
  explicit Command(Words words) : words_(std::move(words)) {
    for (std::string& word : words_) pointers_.push_back(word.data());
    pointers_.push_back(nullptr);
    posix_spawn_file_actions_init(&actions_);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
      posix_spawn_file_actions_addopen(&actions_, stream, "/dev/null", O_WRONLY, 0);
    }
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  }
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  ~Command() { posix_spawn_file_actions_destroy(&actions_); }

  Run run() {
    rusage usage{};
    int status = 0;
    const double wall = timed([&] {
      pid_t child = 0;
      const int problem = posix_spawn(&child, pointers_[0], &actions_, nullptr, pointers_.data(), environ);
      if (problem != 0) throw std::runtime_error(fmt::format("{} does not start", words_[0]));
      return wait4(child, &status, 0, &usage);
    });
    const auto ms = [](const timeval& t) {
      return 1000.0 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_usec) / 1000.0;
    };
    return {wall, ms(usage.ru_utime), ms(usage.ru_stime), usage.ru_maxrss,
            WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status)};
  }

 private:
  Words words_;
  std::vector<char*> pointers_;
  posix_spawn_file_actions_t actions_;
};

Words words_of(const std::string& line) {
  Words words;
  std::istringstream in(line);
  for (std::string word; std::getline(in, word, '\t');) words.push_back(word);
  return words;
}

}  // namespace

void measure_processes(int rounds) {
  std::vector<std::unique_ptr<Command>> commands;
  for (std::string line; std::getline(std::cin, line);) {
    commands.push_back(std::make_unique<Command>(words_of(line)));
  }
  for (auto& command : commands) command->run();  // fills the caches
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < commands.size(); ++i) {
      const Run run = commands[i]->run();
      fmt::print(
          "process command={} wall_ms={:.4f} user_ms={:.3f} system_ms={:.3f} peak_kilobytes={} status={}\n",
          i, run.wall_ms, run.user_ms, run.system_ms, run.peak_kilobytes, run.status);
    }
  }
}

}  // namespace trace::bench
