// Numbers of the scene language:  [+-] (digits [. digits] | . digits) [(e|E) [+-] digits]
//
// The value is the nearest double, as atof gives it; what is too small becomes 0 or a denormal.
#pragma once

namespace trace::parser {

enum class NumberState { good, malformed, out_of_range };

struct NumberText {
  const char* end = nullptr;  // behind the number, or behind the whole malformed run
  double value = 0;           // 0 unless good
  NumberState state = NumberState::good;
};

// `at` is at a character for which begins_number holds. NUL bytes follow the text at `end`. A word may follow
// the number without a blank only where it is a reserved one ("index=1shininess=2"); otherwise the whole run
// of number and word is malformed: '0x10', '1f', '1-2', '1.2.3'.
NumberText read_number(const char* at, const char* end);

inline bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
inline bool begins_number(char c) {
  return is_digit(c) || c == '-' || c == '.' || c == '+';
}
inline bool begins_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
inline bool continues_word(char c) {
  return begins_word(c) || is_digit(c) || c == '-';
}

}  // namespace trace::parser
