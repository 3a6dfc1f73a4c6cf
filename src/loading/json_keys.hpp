// Objects with known keys: each key's value is checked and stored, what does not fit is an error at its
// place.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "loading/json_file.hpp"

namespace trace {

// What a key takes, and where its value goes.
struct JsonKey {
  std::string expects;                         // "true or false"
  std::function<bool(const JsonValue&)> take;  // false where the value does not fit
};

using JsonKeys = std::map<std::string, JsonKey, std::less<>>;

// A null target means that the value is checked and has no effect.
JsonKey boolean_key(std::optional<bool>* target);
JsonKey whole_key(std::optional<int>* target, int low, int high);
JsonKey number_key(std::optional<double>* target, double low = 0, double high = 1e300);
JsonKey text_key(std::optional<std::string>* target);
// Null is allowed too and clears the target.
JsonKey number_or_null_key(std::optional<double>* target, double low = 0, double high = 1e300);

// Gives each member to its key. A value that does not fit is an error: "'size' takes a whole number from 1 to
// 9". A key that is not known is an error, "unknown NOUN 'siez'", or where `lenient` a warning, "unknown NOUN
// 'siez' has no effect", with the nearest known one.
void take_members(const JsonValue::Object& object, const JsonKeys& keys, std::string_view noun, bool lenient,
                  parser::Diagnostics& diagnostics);

}  // namespace trace
