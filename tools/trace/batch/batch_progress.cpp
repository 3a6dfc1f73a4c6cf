#include "tools/trace/batch/batch_progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>

#include "batch/run_job.hpp"

namespace trace {

using namespace std::chrono_literals;

BatchProgress::Style BatchProgress::Style::of_standard_error(bool quiet) {
  Style style;
  style.quiet = quiet;
  style.terminal = isatty(STDERR_FILENO);
  const char* no_color = std::getenv("NO_COLOR");
  const char* kind = std::getenv("TERM");
  const bool dumb = !kind || std::string_view(kind) == "dumb";
  if (dumb) style.terminal = false;
  style.color = style.terminal && !(no_color && *no_color);
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) style.columns = size.ws_col;
  return style;
}

BatchProgress::~BatchProgress() {
  clear_line();
}

void BatchProgress::clear_line() {
  if (!line_shown_) return;
  fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  line_shown_ = false;
}

void BatchProgress::finished(const Record& record, const BatchStatus& status) {
  const bool failure = is_failure(record);
  const std::string message = record.at("message").get<std::string>();
  const bool not_rendered = record.at("outcome") != outcome::rendered;
  const bool show = style_.terminal ? failure : !style_.quiet;
  if (!show && !(not_rendered && !message.empty())) return;
  clear_line();
  if (show && !style_.quiet) {
    const std::string line = result_line(record, several_renderers_);
    const std::string count = style_.terminal ? "" : fmt::format("[{}/{}] ", status.done, status.total);
    if (failure && style_.color) {
      fmt::print(stderr, "{}\033[31m{}\033[0m\n", count, line);
    } else {
      fmt::print(stderr, "{}{}\n", count, line);
    }
  }
  if (not_rendered || !style_.quiet) fmt::print(stderr, "{}", message);
  std::fflush(stderr);
}

void BatchProgress::tick(const BatchStatus& status) {
  if (!style_.terminal || style_.quiet) return;
  const auto now = std::chrono::steady_clock::now();
  if (line_shown_ && now - last_tick_ < 100ms) return;
  last_tick_ = now;
  fmt::print(stderr, "\r\033[K{}", status_line(status, style_.columns - 1));
  std::fflush(stderr);
  line_shown_ = true;
}

std::string result_line(const Record& record, bool with_renderer) {
  std::string name = record.at("scene").get<std::string>();
  if (with_renderer) name += fmt::format(" ({})", record.at("renderer").get<std::string>());
  const Record& outcome = record.at("outcome");
  const double seconds = record.at("seconds").get<double>();
  const std::string time =
      seconds < 9.9995 ? fmt::format("{:.0f} ms", 1000 * seconds) : fmt::format("{:.1f} s", seconds);
  if (outcome != outcome::rendered) return fmt::format("{}: {}, {}", name, outcome.get<std::string>(), time);
  const Record& comparison = record.at("comparison");
  if (comparison.is_null()) return fmt::format("{}: rendered, {}", name, time);
  const std::string verdict = comparison.at("verdict").get<std::string>();
  const std::string reason = comparison.at("reason").get<std::string>();
  std::string line = fmt::format("{}: {}, {}", name, reason.empty() ? verdict : reason, time);
  if (const Record& diagnosis = comparison.at("diagnosis"); !diagnosis.is_null())
    line += "; " + diagnosis.at("text").get<std::string>();
  return line;
}

std::string status_line(const BatchStatus& status, int columns) {
  std::string line = fmt::format("[{}/{}]", status.done, status.total);
  if (status.rays > 0 && status.seconds > 0)
    line += fmt::format(" {:.1f} Mrays/s,", 1e-6 * static_cast<double>(status.rays) / status.seconds);
  if (status.seconds_left >= 0) line += fmt::format(" {:.0f} s left,", status.seconds_left);
  if (status.failures > 0)
    line += fmt::format(" {} failure{},", status.failures, status.failures == 1 ? "" : "s");
  if (line.back() == ',') line.pop_back();
  if (!status.running.empty()) line += fmt::format(": {}", fmt::join(status.running, " "));
  if (static_cast<int>(line.size()) > columns) line.resize(static_cast<std::size_t>(std::max(columns, 0)));
  return line;
}

}  // namespace trace
