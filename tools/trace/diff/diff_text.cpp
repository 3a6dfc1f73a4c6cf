#include "tools/trace/diff/diff_text.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "parser/printable.hpp"
#include "tools/trace/diff/figures_text.hpp"

namespace trace {
namespace {

constexpr std::size_t widest_name = 40;

// File names come from outside: nothing in them reaches the terminal raw.
std::string shown(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const parser::PrintableCharacter character = parser::printable_character(text, at);
    result += character.shown;
    at += character.bytes;
  }
  return result;
}

std::string coloured(const std::string& text, Verdict verdict, bool colour) {
  if (!colour) return text;
  const int code = verdict == Verdict::identical || verdict == Verdict::within ? 32 : 31;
  return fmt::format("\033[{}m{}\033[0m", code, text);
}

std::string_view words(Verdict verdict) {
  switch (verdict) {
    case Verdict::identical:
      return "identical";
    case Verdict::within:
      return "within tolerance";
    case Verdict::beyond:
      return "beyond tolerance";
    case Verdict::not_finite:
      return "not finite";
    case Verdict::size_differs:
      return "size differs";
    case Verdict::channels_differ:
      return "channels differ";
    case Verdict::unreadable:
      return "unreadable";
    case Verdict::missing:
      return "missing";
    case Verdict::extra:
      return "extra";
  }
  return "";
}

// The reason without the verdict, with which some reasons begin: it is told already.
std::string reason(const Judgement& judgement) {
  std::string_view text = judgement.reason;
  const std::string_view told = words(judgement.verdict);
  if (text.starts_with(told) && text.substr(told.size()).starts_with(": "))
    text.remove_prefix(told.size() + 2);
  return shown(text);
}

// What stands behind the name in a line of a folder.
std::string remark(const Judgement& judgement) {
  std::string text = reason(judgement);
  if (judgement.verdict == Verdict::within && judgement.measurements) {
    const Measurements& m = *judgement.measurements;
    text = fmt::format("RMSE {}, {} % of pixels differ", figure(m.error.root_mean_square),
                       figure(m.percent_different));
  }
  if (judgement.diagnosis) text += "; " + judgement.diagnosis->text;
  return text;
}

std::string counts(const DiffReport& report) {
  std::string text =
      fmt::format("{} {}:", report.pairs.size(), report.pairs.size() == 1 ? "picture" : "pictures");
  const char* separator = " ";
  for (const Verdict verdict : all_verdicts) {
    const std::size_t count = report.count(verdict);
    if (count == 0) continue;
    text += fmt::format("{}{} {}", separator, count, words(verdict));
    separator = ", ";
  }
  return text;
}

}  // namespace

bool colour_wanted() {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  return isatty(STDOUT_FILENO) && !(no_color && *no_color) && terminal &&
         std::string_view(terminal) != "dumb";
}

std::string verdict_text(const Judgement& judgement) {
  std::string text(words(judgement.verdict));
  if (!judgement.reason.empty()) text += ": " + reason(judgement);
  return text;
}

std::string pair_text(const ComparedPair& pair, bool colour) {
  const Judgement& judgement = pair.judgement;
  std::string text = coloured(verdict_text(judgement), judgement.verdict, colour) + "\n";
  if (judgement.diagnosis) text += fmt::format("diagnosis: {}\n", judgement.diagnosis->text);
  if (judgement.measurements) text += figures_text(*judgement.measurements);
  return text;
}

std::string folder_text(const DiffReport& report, bool colour) {
  std::size_t verdict_width = 0, name_width = 0;
  for (const ComparedPair& pair : report.pairs) {
    verdict_width = std::max(verdict_width, words(pair.judgement.verdict).size());
    name_width = std::max(name_width, std::min(shown(pair.name).size(), widest_name));
  }
  std::string text;
  for (const ComparedPair& pair : report.pairs) {
    const Judgement& judgement = pair.judgement;
    const std::string verdict = fmt::format("{:<{}}", words(judgement.verdict), verdict_width);
    const std::string line = fmt::format("{:<{}}  {}", shown(pair.name), name_width, remark(judgement));
    text += coloured(verdict, judgement.verdict, colour) + "  " +
            line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text + counts(report) + "\n";
}

}  // namespace trace
