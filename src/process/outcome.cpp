#include "process/outcome.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <array>
#include <cstring>
#include <string_view>

#include "image/system_error.hpp"

namespace trace {
namespace {

std::string signal_text(int signal) {
  const char* description = sigdescr_np(signal);
  if (description == nullptr) return fmt::format("signal {}", signal);
  std::string all = description;  // "Segmentation fault"
  if (all.size() > 1 && all[1] >= 'a' && all[1] <= 'z' && all[0] >= 'A' && all[0] <= 'Z')
    all[0] = char(all[0] - 'A' + 'a');
  return all;
}

}  // namespace

std::string text(const Outcome& outcome) {
  switch (outcome.kind) {
    case Outcome::Kind::answered:
      return "done";
    case Outcome::Kind::exited:
      return fmt::format("exited with status {}", outcome.number);
    case Outcome::Kind::signalled:
      return fmt::format("crashed ({})", signal_text(outcome.number));
    case Outcome::Kind::timed_out:
      return "ran out of time";
    case Outcome::Kind::out_of_memory:
      return "ran out of memory";
    case Outcome::Kind::could_not_start:
      break;
  }
  return fmt::format("could not be started: {}", system_reason(outcome.number));
}

Outcome outcome_of_status(int wait_status) {
  if (WIFSIGNALED(wait_status)) return {Outcome::Kind::signalled, WTERMSIG(wait_status)};
  return {Outcome::Kind::exited, WEXITSTATUS(wait_status)};
}

bool speaks_of_memory(const std::string& errors) {
  constexpr std::array<std::string_view, 7> phrases = {
      "std::bad_alloc", "Cannot allocate memory", "cannot allocate memory", "Out of memory", "out of memory",
      "MemoryError",    "memory exhausted"};
  for (std::string_view phrase : phrases) {
    if (errors.find(phrase) != std::string::npos) return true;
  }
  return false;
}

}  // namespace trace
