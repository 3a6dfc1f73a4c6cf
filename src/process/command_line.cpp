#include "process/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trace {
namespace {

constexpr std::string_view blanks = " \t\n\r";

// Reads one command from left to right.
class Splitter {
 public:
  explicit Splitter(std::string_view text) : text_(text) {}

  std::vector<std::string> all() {
    std::vector<std::string> words;
    for (skip_blanks(); at_ < text_.size(); skip_blanks()) words.push_back(word());
    if (words.empty()) throw CommandError("the command is empty", 0);
    return words;
  }

 private:
  void skip_blanks() { at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size()); }

  std::string word() {
    std::string result;
    while (at_ < text_.size() && blanks.find(text_[at_]) == std::string_view::npos) {
      const char c = text_[at_];
      if (c == '\'' || c == '"') {
        quoted(c, result);
      } else if (c == '\\') {
        if (at_ + 1 == text_.size()) throw CommandError("a backslash with nothing behind it", at_);
        result += text_[at_ + 1];
        at_ += 2;
      } else {
        result += c;
        ++at_;
      }
    }
    return result;
  }

  void quoted(char quote, std::string& result) {
    constexpr std::string_view escapable = "\"\\$`";
    const std::size_t start = at_++;
    for (; at_ < text_.size() && text_[at_] != quote; ++at_) {
      const bool escapes = quote == '"' && text_[at_] == '\\' && at_ + 1 < text_.size() &&
                           escapable.find(text_[at_ + 1]) != std::string_view::npos;
      if (escapes) ++at_;
      result += text_[at_];
    }
    if (at_ == text_.size()) throw CommandError(fmt::format("the quote {} is not closed", quote), start);
    ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

const std::string& value_of(const std::string& name, std::size_t position,
                            const std::vector<Placeholder>& placeholders) {
  const auto found = std::find_if(placeholders.begin(), placeholders.end(),
                                  [&](const Placeholder& known) { return known.name == name; });
  if (found != placeholders.end()) return found->value;
  std::string known;
  for (const Placeholder& one : placeholders)
    known += fmt::format("{}{{{}}}", known.empty() ? "" : ", ", one.name);
  throw CommandError(fmt::format("unknown placeholder {{{}}}: there are {}", name, known), position);
}

std::string fill_in_one(const std::string& argument, const std::vector<Placeholder>& placeholders) {
  std::string result;
  for (std::size_t at = 0; at < argument.size(); ++at) {
    const char c = argument[at];
    const bool doubled = at + 1 < argument.size() && argument[at + 1] == c;
    if (c != '{' && c != '}') {
      result += c;
    } else if (doubled) {
      result += c;
      ++at;
    } else if (const std::size_t end = argument.find('}', at); c == '{' && end != std::string::npos) {
      result += value_of(argument.substr(at + 1, end - at - 1), at, placeholders);
      at = end;
    } else {
      throw CommandError(fmt::format("a {0} alone: {0}{0} stands for the brace itself", c), at);
    }
  }
  return result;
}

}  // namespace

std::vector<std::string> parse_command(std::string_view command) {
  return Splitter(command).all();
}

std::vector<std::string> fill_in(const std::vector<std::string>& arguments,
                                 const std::vector<Placeholder>& placeholders) {
  std::vector<std::string> result;
  for (const std::string& argument : arguments) result.push_back(fill_in_one(argument, placeholders));
  return result;
}

}  // namespace trace
