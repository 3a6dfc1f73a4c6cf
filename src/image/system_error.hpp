// The operating system's reason for a failure, in the form our messages use.
#pragma once

#include <string>
#include <system_error>

namespace trace {

// The text for an errno value, without a capital at the start: "permission denied".
inline std::string system_reason(int error) {
  std::string text = std::generic_category().message(error);
  if (text.size() > 1 && text[0] >= 'A' && text[0] <= 'Z' && text[1] >= 'a' && text[1] <= 'z')
    text[0] = char(text[0] - 'A' + 'a');
  return text;
}

}  // namespace trace
