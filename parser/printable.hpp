// Scene text as it may be shown on a terminal: control characters, invalid UTF-8 and the characters that turn
// the direction of writing are spelled out, everything else stands as it is.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace trace::parser {

// Length in bytes of the UTF-8 sequence that begins at text[at]; 0 where there is no valid one.
std::size_t utf8_length(std::string_view text, std::size_t at);

// The code point of the valid sequence text[at, at + length).
char32_t utf8_code_point(std::string_view text, std::size_t at, std::size_t length);

// One character of a text, ready to be shown.
struct PrintableCharacter {
  std::size_t bytes = 1;    // of the text
  std::size_t columns = 1;  // on the screen
  std::string shown;
};
PrintableCharacter printable_character(std::string_view text, std::size_t at);

// The text, printable, cut after about 40 characters.
std::string printable(std::string_view text);
// The same in single quotes: 'difuse'.
std::string in_quotes(std::string_view text);

// The name of an unexpected character: '#', '\x00', U+00A0.
std::string character_name(std::string_view text, std::size_t at);

}  // namespace trace::parser
