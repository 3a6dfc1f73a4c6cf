// Digits small enough to be drawn into a picture.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace trace {

inline constexpr int digit_width = 3, digit_height = 5;

// Rows of a character from the top, each of three bits, the leftmost the highest: of 0 to 9 and '.', nothing
// for any other.
inline std::array<std::uint8_t, digit_height> digit_rows(char character) {
  constexpr std::string_view known = "0123456789.";
  constexpr std::array<std::array<std::uint8_t, digit_height>, known.size()> rows{
      {{0b111, 0b101, 0b101, 0b101, 0b111},
       {0b010, 0b110, 0b010, 0b010, 0b111},
       {0b111, 0b001, 0b111, 0b100, 0b111},
       {0b111, 0b001, 0b111, 0b001, 0b111},
       {0b101, 0b101, 0b111, 0b001, 0b001},
       {0b111, 0b100, 0b111, 0b001, 0b111},
       {0b111, 0b100, 0b111, 0b101, 0b111},
       {0b111, 0b001, 0b010, 0b010, 0b010},
       {0b111, 0b101, 0b111, 0b101, 0b111},
       {0b111, 0b101, 0b111, 0b001, 0b111},
       {0b000, 0b000, 0b000, 0b000, 0b010}}};
  const std::size_t found = known.find(character);
  return found == std::string_view::npos ? std::array<std::uint8_t, digit_height>{} : rows[found];
}

}  // namespace trace
