#include "process/run_program.hpp"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "process/bounded_text.hpp"
#include "process/cpu_time.hpp"
#include "process/descriptor.hpp"
#include "process/exec_strings.hpp"
#include "process/keeper.hpp"
#include "process/memory_watch.hpp"
#include "process/pipe.hpp"

namespace trace {
namespace {

using Clock = std::chrono::steady_clock;

// The keeper needs no time to speak of unless something cannot be killed.
constexpr std::chrono::seconds patience{10};

class Run {
 public:
  Run(std::vector<std::string> arguments, const ProgramOptions& options) : options_(options) {
    start(std::move(arguments));
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  // The keeper never outlives this, whatever was thrown.
  ~Run() {
    if (keeper_ < 0) return;
    kill(keeper_, ended_ ? SIGKILL : SIGTERM);
    while (waitpid(keeper_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }

  ProgramResult result() {
    while (!ended_) {
      wait_for_news();
      watch();
    }
    read_output();
    ProgramResult result;
    result.outcome = outcome();
    result.output = output_text_.text();
    result.errors = errors_text_.text();
    result.seconds = std::chrono::duration<double>(Clock::now() - started_).count();
    result.cpu_seconds = report_ ? cpu_seconds(report_->usage) : 0;
    result.peak_memory_bytes = memory_.peak(report_ ? report_->usage : rusage{});
    return result;
  }

 private:
  void start(std::vector<std::string> arguments);
  void wait_for_news();
  void watch();
  void read_output();
  void read_failure();
  void read_report();
  void stop(Outcome::Kind reason);
  Outcome outcome() const;

  const ProgramOptions& options_;
  Clock::time_point started_ = Clock::now();
  MemoryWatch memory_{options_.limits.memory_bytes};
  pid_t keeper_ = -1;
  Descriptor output_, errors_, failure_, report_pipe_;
  BoundedText output_text_, errors_text_;
  int start_error_ = 0;
  std::optional<KeeperReport> report_;
  bool ended_ = false;
  std::optional<Outcome::Kind> stopped_for_;
  Clock::time_point stopped_at_;
};

void Run::start(std::vector<std::string> arguments) {
  const std::string file = arguments[0].find('/') == std::string::npos
                               ? arguments[0]
                               : std::filesystem::absolute(arguments[0]).string();
  const ExecStrings argument_strings(std::move(arguments)),
      environment(changed_environment(options_.environment));
  Pipe output, errors, failure, report;

  ProgramStart start;
  start.file = file.c_str();
  start.arguments = argument_strings.pointers();
  start.environment = environment.pointers();
  start.folder = options_.folder.empty() ? nullptr : options_.folder.c_str();
  start.memory_bytes = options_.refuse_allocations ? options_.limits.memory_bytes : 0;
  start.largest_file = options_.largest_file;
  start.output = output.write.get();
  start.errors = options_.errors_apart ? errors.write.get() : output.write.get();
  start.failure = failure.write.get();
  start.report = report.write.get();

  const pid_t parent = getpid();
  keeper_ = fork();
  if (keeper_ == 0) keep_program(start, parent);
  if (keeper_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  output_ = std::move(output.read);
  errors_ = std::move(errors.read);
  failure_ = std::move(failure.read);
  report_pipe_ = std::move(report.read);
  for (const Descriptor* descriptor : {&output_, &errors_, &failure_, &report_pipe_})
    must_not_block(*descriptor);
}

void Run::wait_for_news() {
  auto until = Clock::now() + std::chrono::seconds(60);
  if (stopped_for_) {
    until = stopped_at_ + patience;
  } else if (options_.limits.timeout.count() > 0) {
    until = std::min(until, started_ + std::chrono::duration_cast<Clock::duration>(options_.limits.timeout));
  }
  if (!failure_ && !stopped_for_) until = std::min(until, memory_.next_look());
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
  std::array<pollfd, 4> watched{{{output_.get(), POLLIN, 0},
                                 {errors_.get(), POLLIN, 0},
                                 {failure_.get(), POLLIN, 0},
                                 {report_pipe_.get(), POLLIN, 0}}};
  if (poll(watched.data(), watched.size(), int(std::max<std::int64_t>(left, 0))) <= 0) return;
  read_output();
  if (watched[2].revents != 0) read_failure();
  if (watched[3].revents != 0) read_report();
}

void Run::read_output() {
  read_some(output_, output_text_);
  read_some(errors_, errors_text_);
}

// Either the reason why the program could not be started, or nothing: the program closed it by starting.
void Run::read_failure() {
  int error = 0;
  if (read(failure_.get(), &error, sizeof error) == sizeof error) start_error_ = error;
  failure_.reset();
}

void Run::read_report() {
  KeeperReport report;
  if (read(report_pipe_.get(), &report, sizeof report) == sizeof report) report_ = report;
  ended_ = true;
}

void Run::watch() {
  const auto now = Clock::now();
  const Limits& limits = options_.limits;
  if (stopped_for_ && now > stopped_at_ + patience) ended_ = true;
  if (ended_ || stopped_for_) return;
  if (limits.timeout.count() > 0 && now - started_ >= limits.timeout) return stop(Outcome::Kind::timed_out);
  if (failure_ || now < memory_.next_look()) return;  // before it has started, the memory is still ours
  if (memory_.look(keeper_, now)) stop(Outcome::Kind::out_of_memory);
}

void Run::stop(Outcome::Kind reason) {
  stopped_for_ = reason;
  stopped_at_ = Clock::now();
  kill(keeper_, SIGTERM);
}

Outcome Run::outcome() const {
  if (start_error_ != 0) return {Outcome::Kind::could_not_start, start_error_};
  // Without a report the keeper was killed, and the program with it.
  const Outcome own =
      report_ ? outcome_of_status(report_->status) : Outcome{Outcome::Kind::signalled, SIGKILL};
  const bool was_killed = own == Outcome{Outcome::Kind::signalled, SIGKILL};
  if (was_killed && stopped_for_) return {*stopped_for_, 0};
  const bool refused = options_.refuse_allocations && options_.limits.memory_bytes > 0 &&
                       own != Outcome{Outcome::Kind::exited, 0} &&
                       (speaks_of_memory(output_text_.text()) || speaks_of_memory(errors_text_.text()));
  return refused ? Outcome{Outcome::Kind::out_of_memory, 0} : own;
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& arguments, const ProgramOptions& options) {
  if (arguments.empty()) throw std::invalid_argument("a program to run needs a name");
  return Run(arguments, options).result();
}

}  // namespace trace
