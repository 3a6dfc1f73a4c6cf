// A command as people write it, to the arguments of the program it names. No shell is involved.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace trace {

// What is wrong with a command, and where: `position` counts bytes from 0.
class CommandError : public std::runtime_error {
 public:
  CommandError(const std::string& what, std::size_t position)
      : std::runtime_error(what), position_(position) {}
  std::size_t position() const { return position_; }

 private:
  std::size_t position_;
};

// Splits at blanks, with the quoting of the shell: '...' takes everything as it is; in "..." a backslash
// stands before " \ $ and `; elsewhere a backslash takes the next character as it is. Nothing else is
// special: no variables, patterns, pipes. Throws CommandError for an empty command, a quote that is not
// closed and a backslash at the end.
std::vector<std::string> parse_command(std::string_view command);

// A name that stands for something in a command: {scene}.
struct Placeholder {
  std::string name, value;
};

// Puts the values into the arguments; {{ and }} are braces. To be done after parse_command(), so that a value
// with blanks stays one argument. Throws CommandError for an unknown name ("unknown placeholder {size}: there
// are {scene}, {out}") and for a brace without its partner; the position is within that argument.
std::vector<std::string> fill_in(const std::vector<std::string>& arguments,
                                 const std::vector<Placeholder>& placeholders);

}  // namespace trace
