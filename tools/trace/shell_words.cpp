#include "tools/trace/shell_words.hpp"

namespace trace {
namespace {

// As a shell would take it.
std::string quoted(const std::string& word) {
  const std::string harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
  if (!word.empty() && word.find_first_not_of(harmless) == word.npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

}  // namespace

std::string command_line(int argc, const char* const* argv) {
  std::string text = "trace";
  for (int i = 0; i < argc; ++i) text += " " + quoted(argv[i]);
  return text;
}

}  // namespace trace
