// Reads the attributes of one light of a dialect, and says what is wrong with them at their places.
#pragma once

#include <initializer_list>
#include <optional>
#include <set>
#include <string_view>

#include "geometry/vector.hpp"
#include "parser/description.hpp"
#include "parser/diagnostic.hpp"

namespace trace {

class LightAttributes {
 public:
  using Attribute = parser::DialectLight::Attribute;
  using Words = std::initializer_list<std::string_view>;

  LightAttributes(const parser::DialectLight& light, parser::Diagnostics& diagnostics)
      : light_(light), diagnostics_(diagnostics), errors_before_(diagnostics.error_count()) {}

  bool good() const { return diagnostics_.error_count() == errors_before_; }
  bool has(std::string_view word) const { return light_.find(word) != nullptr; }
  bool has_any(Words words) const;

  // The one of several words for the same that is given; null where none is, an error where there are two.
  const Attribute* one_of(Words words);
  // The same, and an error where none is given, which names the first word.
  const Attribute* needed(Words words);

  // The value, or an error and nothing where it is of the other type; nothing of null.
  std::optional<double> number(const Attribute* attribute);
  std::optional<Vec3> vector(const Attribute* attribute);
  // A number, or the first of three of which the others should be 0.
  std::optional<double> leading_number(const Attribute* attribute);
  // A number within bounds; `expects` is the error's end: "must be greater than 0".
  std::optional<double> positive(const Attribute* attribute);
  std::optional<double> not_negative(const Attribute* attribute);
  // A vector, of unit length then.
  std::optional<Vec3> direction(const Attribute* attribute);

  void error(const Attribute& attribute, std::string text);  // at its value
  void warning(const Attribute& attribute, std::string text);
  void missing(std::string_view what);

  // Warns of attributes that nobody has asked for.
  void warn_of_unused();

 private:
  const parser::DialectLight& light_;
  parser::Diagnostics& diagnostics_;
  std::size_t errors_before_;
  std::set<std::string_view> used_;
};

}  // namespace trace
