// Where a command's text goes: a file that appears whole or not at all, or standard output, called "-".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "image/atomic_file.hpp"

namespace trace {

class TextOutput {
 public:
  // An empty name is no output at all. Throws ImageError, whose text names the file, where it may not be
  // written, so that this is known before the work is done.
  explicit TextOutput(const std::string& name);

  bool wanted() const { return !name_.empty(); }
  bool is_standard_output() const { return name_ == "-"; }

  // Writes and closes. Throws ImageError as above; the file is then as it was.
  void write(std::string_view text);

 private:
  std::string name_;
  std::optional<AtomicFile> file_;
};

// All of it, at once. Throws ImageError.
void write_standard_output(std::string_view text);

// To standard error, where failing to is nothing to stop for. Control characters other than line ends and
// tabs, and what is not UTF-8, become visible: \x1b.
void print_errors(std::string_view text);

// The same as text, for names and the output of programs.
std::string terminal_text(std::string_view text);

}  // namespace trace
