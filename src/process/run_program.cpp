#include "process/run_program.hpp"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "process/bounded_text.hpp"
#include "process/cpu_time.hpp"
#include "process/descriptor.hpp"
#include "process/keeper.hpp"
#include "process/pidfd.hpp"
#include "process/pipe.hpp"
#include "process/process_files.hpp"

namespace trace {
namespace {

using Clock = std::chrono::steady_clock;

// Between two looks at the memory: to keep a limit, and just to know.
constexpr std::chrono::milliseconds limited_interval{5}, measured_interval{20};
// The keeper needs no time to speak of unless something cannot be killed.
constexpr std::chrono::seconds patience{10};

// Ours with `changes` made to it.
std::vector<std::string> environment_with(const std::vector<std::string>& changes) {
  std::vector<std::string> all = changes;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string own = *entry;
    const std::string name = own.substr(0, own.find('=') + 1);
    const bool changed = std::any_of(changes.begin(), changes.end(),
                                     [&](const std::string& change) { return change.starts_with(name); });
    if (!changed) all.push_back(own);
  }
  return all;
}

// As exec wants them; good as long as `strings`.
std::vector<char*> pointers(std::vector<std::string>& strings) {
  std::vector<char*> all;
  for (std::string& one : strings) all.push_back(one.data());
  all.push_back(nullptr);
  return all;
}

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
    pidfd_send_signal(keeper_file_.get(), ended_ ? SIGKILL : SIGTERM, nullptr, 0);
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
    result.peak_memory_bytes = peak_memory();
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
  std::uint64_t peak_memory() const;

  const ProgramOptions& options_;
  Clock::time_point started_ = Clock::now();
  std::uint64_t own_peak_ = peak_resident(getpid());
  pid_t keeper_ = -1;
  Descriptor keeper_file_, output_, errors_, failure_, report_pipe_;
  BoundedText output_text_, errors_text_;
  int start_error_ = 0;
  std::optional<KeeperReport> report_;
  bool ended_ = false;
  std::optional<Outcome::Kind> stopped_for_;
  Clock::time_point stopped_at_;
  std::uint64_t peak_seen_ = 0;
};

void Run::start(std::vector<std::string> arguments) {
  const std::string file = arguments[0].find('/') == std::string::npos
                               ? arguments[0]
                               : std::filesystem::absolute(arguments[0]).string();
  std::vector<std::string> environment = environment_with(options_.environment);
  const std::vector<char*> argument_pointers = pointers(arguments),
                           environment_pointers = pointers(environment);
  Pipe output, errors, failure, report;

  ProgramStart start;
  start.file = file.c_str();
  start.arguments = argument_pointers.data();
  start.environment = environment_pointers.data();
  start.folder = options_.folder.empty() ? nullptr : options_.folder.c_str();
  start.memory_bytes = options_.limits.memory_bytes;
  start.largest_file = options_.largest_file;
  start.output = output.write.get();
  start.errors = options_.errors_apart ? errors.write.get() : output.write.get();
  start.failure = failure.write.get();
  start.report = report.write.get();

  const pid_t parent = getpid();
  keeper_ = fork();
  if (keeper_ == 0) keep_program(start, parent);
  if (keeper_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  keeper_file_ = Descriptor(pidfd_open(keeper_, 0));
  output_ = std::move(output.read);
  errors_ = std::move(errors.read);
  failure_ = std::move(failure.read);
  report_pipe_ = std::move(report.read);
  for (const Descriptor* descriptor : {&output_, &errors_, &failure_, &report_pipe_})
    must_not_block(*descriptor);
}

void Run::wait_for_news() {
  const bool looks_at_memory = !failure_ && !stopped_for_;  // before, the memory is still ours
  auto until = Clock::now() + std::chrono::seconds(60);
  if (stopped_for_) {
    until = stopped_at_ + patience;
  } else if (options_.limits.timeout.count() > 0) {
    until = std::min(until, started_ + std::chrono::duration_cast<Clock::duration>(options_.limits.timeout));
  }
  if (looks_at_memory) {
    const auto interval = options_.limits.memory_bytes > 0 ? limited_interval : measured_interval;
    until = std::min<Clock::time_point>(until, Clock::now() + interval);
  }
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
  if (failure_) return;
  const std::vector<pid_t> processes = descendants(keeper_);
  std::uint64_t together = 0;
  for (pid_t process : processes) together += resident_memory(process).all;
  // Pages that the processes share were counted once for each; that takes longer to find out.
  if (limits.memory_bytes > 0 && together > limits.memory_bytes && processes.size() > 1) {
    together = 0;
    for (pid_t process : processes) together += proportional_memory(process);
  }
  peak_seen_ = std::max(peak_seen_, together);
  if (limits.memory_bytes > 0 && together > limits.memory_bytes) stop(Outcome::Kind::out_of_memory);
}

void Run::stop(Outcome::Kind reason) {
  stopped_for_ = reason;
  stopped_at_ = Clock::now();
  pidfd_send_signal(keeper_file_.get(), SIGTERM, nullptr, 0);
}

Outcome Run::outcome() const {
  if (start_error_ != 0) return {Outcome::Kind::could_not_start, start_error_};
  // Without a report the keeper was killed, and the program with it.
  const Outcome own =
      report_ ? outcome_of_status(report_->status) : Outcome{Outcome::Kind::signalled, SIGKILL};
  const bool was_killed = own == Outcome{Outcome::Kind::signalled, SIGKILL};
  if (was_killed && stopped_for_) return {*stopped_for_, 0};
  const bool refused = options_.limits.memory_bytes > 0 && !own.success() &&
                       (speaks_of_memory(output_text_.text()) || speaks_of_memory(errors_text_.text()));
  return refused ? Outcome{Outcome::Kind::out_of_memory, 0} : own;
}

std::uint64_t Run::peak_memory() const {
  // The kernel's own figure counts from the fork on, when the process had our memory, so it means something
  // only where it is more than that.
  const std::uint64_t largest = report_ ? std::uint64_t(report_->usage.ru_maxrss) * 1024 : 0;
  return std::max(peak_seen_, largest > own_peak_ ? largest : 0);
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& arguments, const ProgramOptions& options) {
  if (arguments.empty()) throw std::invalid_argument("a program to run needs a name");
  return Run(arguments, options).result();
}

}  // namespace trace
