#include "report/plain_text.hpp"

#include "parser/printable.hpp"

namespace trace {
namespace {

// `keep` decides on each valid character.
template <class Keep>
std::string filtered(std::string_view text, Keep keep) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = parser::utf8_length(text, at);
    if (length == 0) {
      result += "\xEF\xBF\xBD";
      ++at;
      continue;
    }
    if (keep(parser::utf8_code_point(text, at, length))) result += text.substr(at, length);
    at += length;
  }
  return result;
}

}  // namespace

std::string valid_utf8(std::string_view text) {
  return filtered(text, [](char32_t) { return true; });
}

std::string xml_text(std::string_view text) {
  return filtered(text, [](char32_t c) {
    return (c >= 0x20 && c != 0xFFFE && c != 0xFFFF) || c == '\t' || c == '\n' || c == '\r';
  });
}

}  // namespace trace
