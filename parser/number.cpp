#include "parser/number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <system_error>

#include "parser/vocabulary.hpp"

namespace trace::parser {

namespace {

// Behind the longest number that begins at `at`; null where there is none.
const char* match(const char* at) {
  if (*at == '+' || *at == '-') ++at;
  const char* const digits = at;
  while (is_digit(*at)) ++at;
  std::ptrdiff_t count = at - digits;
  if (*at == '.') {
    const char* const fraction = ++at;
    while (is_digit(*at)) ++at;
    count += at - fraction;
  }
  if (count == 0) return nullptr;
  if (*at == 'e' || *at == 'E') {
    const char* exponent = at + 1;
    if (*exponent == '+' || *exponent == '-') ++exponent;
    if (!is_digit(*exponent)) return at;
    while (is_digit(*exponent)) ++exponent;
    at = exponent;
  }
  return at;
}

bool continues_run(char c) {
  return continues_word(c) || c == '.' || c == '+';
}

// Whether something that cannot stand directly behind a number follows it.
bool glued(const char* at) {
  if (!continues_run(*at)) return false;
  if (!begins_word(*at) || *at == 'e' || *at == 'E') return true;
  const char* end = at;
  while (continues_word(*end)) ++end;
  return !is_reserved({at, static_cast<std::size_t>(end - at)});
}

// Whether a well-formed number beyond the range of double is beyond it at the small end: the decimal exponent
// of its first significant digit is negative.
bool is_tiny(std::string_view text) {
  const std::size_t mark = text.find_first_of("eE");
  const std::string_view digits = text.substr(0, mark);
  const std::size_t first = digits.find_first_of("123456789");
  if (first == std::string_view::npos) return true;
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const double magnitude = static_cast<double>(point) - static_cast<double>(first);
  if (mark == std::string_view::npos) return magnitude < 0;
  std::string_view written = text.substr(mark + 1);
  const bool negative = written.front() == '-';
  if (negative || written.front() == '+') written.remove_prefix(1);
  double exponent = 0;
  for (const char c : written) exponent = exponent * 10 + (c - '0');
  return magnitude + (negative ? -exponent : exponent) < 0;
}

}  // namespace

NumberText read_number(const char* at, const char* end) {
  const char* const behind = match(at);
  if (behind == nullptr || glued(behind)) {
    const char* run = at;
    while (run < end && continues_run(*run)) ++run;
    return {run, 0, NumberState::malformed};
  }
  NumberText result{behind, 0, NumberState::good};
  const char* const first = *at == '+' ? at + 1 : at;  // from_chars takes no plus sign
  const std::errc error = std::from_chars(first, behind, result.value).ec;
  if (error == std::errc() && std::isfinite(result.value)) return result;
  const bool tiny = is_tiny({first, static_cast<std::size_t>(behind - first)});
  result.value = tiny && *first == '-' ? -0.0 : 0.0;
  result.state = tiny ? NumberState::good : NumberState::out_of_range;
  return result;
}

}  // namespace trace::parser
