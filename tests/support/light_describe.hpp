// Lights of dialects as the parser describes them.
#pragma once

#include <initializer_list>

#include "parser/description.hpp"
#include "parser/diagnostic.hpp"

namespace trace::test {

struct Said {
  std::string_view word;
  std::variant<double, std::array<double, 3>> value;

  Said(std::string_view w, double number) : word(w), value(number) {}
  Said(std::string_view w, double x, double y, double z) : word(w), value(std::array<double, 3>{x, y, z}) {}
};

// Attribute k is at [10 k + 10, 10 k + 15), its value at [10 k + 16, 10 k + 19); the keyword at [0, 5).
inline parser::DialectLight dialect_light(parser::DialectLight::Kind kind, std::string_view word,
                                          std::initializer_list<Said> attributes) {
  parser::DialectLight light;
  light.kind = kind;
  light.word = word;
  light.keyword = {0, 5};
  std::uint32_t at = 10;
  for (const Said& said : attributes) {
    light.attributes.push_back({said.word, said.value, {at, at + 5}, {at + 6, at + 9}});
    at += 10;
  }
  return light;
}

}  // namespace trace::test
