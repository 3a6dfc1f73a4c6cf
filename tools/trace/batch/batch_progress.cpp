#include "tools/trace/batch/batch_progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "batch/run_job.hpp"
#include "tools/trace/text_output.hpp"

namespace trace {

namespace {

// Line ends in a name would break the line that shows it.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

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

// Nobody may be there to see it.
void BatchProgress::show(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

void BatchProgress::clear_line() {
  if (line_shown_) show("\r\033[K");
  line_shown_ = false;
}

void BatchProgress::finished(const Record& record, const BatchStatus& status) {
  const bool failure = is_failure(record);
  std::string message = record.at("message").get<std::string>();
  if (!message.empty() && message.back() != '\n') message += '\n';
  const bool not_rendered = record.at("outcome") != outcome::rendered;
  std::string text;
  if (!style_.quiet && (failure || !style_.terminal)) {
    const std::string line = terminal_text(result_line(record, several_renderers_));
    if (!style_.terminal) text += fmt::format("[{}/{}] ", status.done, status.total);
    text += failure && style_.color ? fmt::format("\033[31m{}\033[0m\n", line) : line + "\n";
  }
  if (not_rendered || !style_.quiet) text += terminal_text(message);
  if (text.empty()) return;
  clear_line();
  show(text);
}

void BatchProgress::tick(const BatchStatus& status) {
  if (!style_.terminal || style_.quiet) return;
  const auto now = std::chrono::steady_clock::now();
  if (line_shown_ && now - last_tick_ < 100ms) return;
  last_tick_ = now;
  show("\r\033[K" + status_line(status, style_.columns - 1));
  line_shown_ = true;
}

std::string result_line(const Record& record, bool with_renderer) {
  std::string name = one_line(record.at("scene").get<std::string>());
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
  line = terminal_text(one_line(line));
  std::size_t size = std::min(line.size(), static_cast<std::size_t>(std::max(columns, 0)));
  while (size < line.size() && size > 0 && (static_cast<unsigned char>(line[size]) & 0xC0) == 0x80) --size;
  line.resize(size);  // not within a character
  return line;
}

}  // namespace trace
