// JSON files that people write: values with their places, so that what does not fit can be shown.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "parser/diagnostic.hpp"

namespace trace {

struct JsonMember;

struct JsonValue {
  using Array = std::vector<JsonValue>;
  using Object = std::vector<JsonMember>;  // in the order of the file; a name may come twice

  parser::Span span;
  std::variant<std::nullptr_t, bool, double, std::string, Array, Object> value;

  // Null where the value is of another kind.
  template <class Kind>
  const Kind* get() const {
    return std::get_if<Kind>(&value);
  }
};

struct JsonMember {
  std::string name;
  parser::Span name_span;  // with its quotes
  JsonValue value;
};

// Lists and objects may be nested so deep, which bounds the recursion of whoever reads the values.
inline constexpr std::size_t max_json_depth = 64;

// The whole text as one value. Where it is not valid JSON the result is empty and the error is in
// `diagnostics`.
std::optional<JsonValue> parse_json(const parser::Source& source, parser::Diagnostics& diagnostics);

}  // namespace trace
