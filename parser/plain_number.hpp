// Numbers as most files write them, read eight characters at a time (little-endian machines): the inner loop
// of the readers of lists. What is not plain is left to read_number (number.hpp); the values are the same
// either way.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "parser/number.hpp"

namespace trace::parser {

static_assert(std::endian::native == std::endian::little);

// The digits at the front of eight characters.
struct DigitRun {
  unsigned count = 0;       // 0 to 8
  std::uint64_t value = 0;  // of those digits
};

// Eight characters at `at` can be read: text_padding NUL bytes follow every text (source.hpp).
[[gnu::always_inline]] inline DigitRun read_digits(const char* at) {
  std::uint64_t characters;
  std::memcpy(&characters, at, 8);
  // In each byte: 0 to 9 for a digit. Adding 0x76 sets the top bit of everything else below 0x80; a carry
  // runs only into bytes behind one that is no digit.
  std::uint64_t digits = characters ^ 0x3030303030303030u;
  const std::uint64_t others = ((digits + 0x7676767676767676u) | digits) & 0x8080808080808080u;
  const unsigned count = others == 0 ? 8 : static_cast<unsigned>(std::countr_zero(others)) / 8;
  if (count == 0) return {};
  digits <<= 64 - 8 * count;             // zeros in front
  digits = digits * 10 + (digits >> 8);  // every second byte: two digits
  constexpr std::uint64_t pairs = 0x000000ff000000ff;
  return {count, ((digits & pairs) * (100 + (std::uint64_t{1000000} << 32)) +
                  ((digits >> 16) & pairs) * (1 + (std::uint64_t{10000} << 32))) >>
                     32};
}

// [-] digits [. digits] with at most 10 digits in front of the point and 15 behind it, as an integer divided
// by a power of ten: correctly rounded while both are exact, which is made sure of (W. D. Clinger, "How to
// read floating point numbers accurately", 1990). Returns where the digits end, or null where it is not such
// a number; whether a number may end there is for the caller to see.
[[gnu::always_inline]] inline const char* read_plain_number(const char* at, double& value) {
  constexpr std::array<double, 16> power_of_ten{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  constexpr std::array<std::uint64_t, 9> whole_power{1,      10,      100,      1000,     10000,
                                                     100000, 1000000, 10000000, 100000000};
  constexpr std::uint64_t most_before_eight = 100'000'000'000;  // times 10^8 there is no overflow
  const bool negative = *at == '-';
  at += negative ? 1 : 0;
  const char* const first = at;
  std::uint64_t digits = 0;
  while (is_digit(*at)) digits = digits * 10 + static_cast<unsigned>(*at++ - '0');
  unsigned decimals = 0;
  bool any = at != first;
  if (at - first > 10) return nullptr;  // so that eight more cannot overflow
  if (*at == '.') {
    const DigitRun run = read_digits(++at);
    digits = digits * whole_power[run.count] + run.value;
    decimals = run.count;
    at += run.count;
    any = any || run.count > 0;
    if (run.count == 8 && is_digit(*at)) {  // some write 17 digits: read_number's
      const DigitRun more = read_digits(at);
      if (digits >= most_before_eight || more.count == 8) return nullptr;
      digits = digits * whole_power[more.count] + more.value;
      decimals += more.count;
      at += more.count;
    }
  }
  if (!any || digits > (std::uint64_t{1} << 53)) return nullptr;
  const double magnitude = static_cast<double>(static_cast<std::int64_t>(digits)) / power_of_ten[decimals];
  value = negative ? -magnitude : magnitude;
  return at;
}

}  // namespace trace::parser
