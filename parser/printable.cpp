#include "parser/printable.hpp"

#include <fmt/format.h>

namespace trace::parser {

namespace {

unsigned byte_at(std::string_view text, std::size_t at) {
  return static_cast<unsigned char>(text[at]);
}

bool hidden(char32_t c) {
  return c < 0x20 || (c >= 0x7f && c < 0xa0) || (c >= 0x200b && c <= 0x200f) ||
         (c >= 0x2028 && c <= 0x202e) || (c >= 0x2060 && c <= 0x206f) || c == 0xfeff;
}

}  // namespace

std::size_t utf8_length(std::string_view text, std::size_t at) {
  const unsigned lead = byte_at(text, at);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte_at(text, at + i) & 0xc0) != 0x80) return 0;
  }
  const char32_t c = utf8_code_point(text, at, length);
  const bool overlong = (length == 3 && c < 0x800) || (length == 4 && c < 0x10000);
  return overlong || c > 0x10ffff || (c >= 0xd800 && c < 0xe000) ? 0 : length;
}

char32_t utf8_code_point(std::string_view text, std::size_t at, std::size_t length) {
  if (length == 1) return byte_at(text, at);
  char32_t c = byte_at(text, at) & (0xffu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) c = c << 6 | (byte_at(text, at + i) & 0x3f);
  return c;
}

PrintableCharacter printable_character(std::string_view text, std::size_t at) {
  const std::size_t length = utf8_length(text, at);
  if (length != 0 && !hidden(utf8_code_point(text, at, length))) {
    return {length, 1, std::string(text.substr(at, length))};
  }
  if (length > 1) {
    const std::string shown =
        fmt::format("<U+{:04X}>", static_cast<unsigned>(utf8_code_point(text, at, length)));
    return {length, shown.size(), shown};
  }
  return {1, 4, fmt::format("\\x{:02X}", byte_at(text, at))};
}

std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t at = 0, characters = 0; at < text.size(); ++characters) {
    if (characters == 40) {
      result += "...";
      break;
    }
    const PrintableCharacter c = printable_character(text, at);
    result += c.shown;
    at += c.bytes;
  }
  return result;
}

std::string in_quotes(std::string_view text) {
  return fmt::format("'{}'", printable(text));
}

std::string character_name(std::string_view text, std::size_t at) {
  const std::size_t length = utf8_length(text, at);
  if (length > 1) return fmt::format("U+{:04X}", static_cast<unsigned>(utf8_code_point(text, at, length)));
  return fmt::format("'{}'", printable_character(text, at).shown);
}

}  // namespace trace::parser
