#include "loading/json_keys.hpp"

#include <fmt/format.h>

namespace trace {
namespace {

std::string range_text(double low, double high) {
  if (high < 1e300) return fmt::format("a number from {} to {}", low, high);
  return low == 0 ? "a number that is not negative" : fmt::format("a number of at least {}", low);
}

}  // namespace

JsonKey boolean_key(std::optional<bool>* target) {
  return {"true or false", [target](const JsonValue& value) {
            const bool* given = value.get<bool>();
            if (given && target) *target = *given;
            return given != nullptr;
          }};
}

JsonKey whole_key(std::optional<int>* target, int low, int high) {
  return {fmt::format("a whole number from {} to {}", low, high), [=](const JsonValue& value) {
            const double* given = value.get<double>();
            if (!given || !(*given >= low && *given <= high) || *given != static_cast<int>(*given))
              return false;
            if (target) *target = static_cast<int>(*given);
            return true;
          }};
}

JsonKey number_key(std::optional<double>* target, double low, double high) {
  return {range_text(low, high), [=](const JsonValue& value) {
            const double* given = value.get<double>();
            if (!given || !(*given >= low && *given <= high)) return false;
            if (target) *target = *given;
            return true;
          }};
}

JsonKey text_key(std::optional<std::string>* target) {
  return {"a text in quotes", [target](const JsonValue& value) {
            const std::string* given = value.get<std::string>();
            if (given && target) *target = *given;
            return given != nullptr;
          }};
}

JsonKey number_or_null_key(std::optional<double>* target, double low, double high) {
  JsonKey key = number_key(target, low, high);
  key.expects += " or null";
  key.take = [target, number = std::move(key.take)](const JsonValue& value) {
    if (!value.get<std::nullptr_t>()) return number(value);
    if (target) target->reset();
    return true;
  };
  return key;
}

void take_members(const JsonValue::Object& object, const JsonKeys& keys, std::string_view noun, bool lenient,
                  parser::Diagnostics& diagnostics) {
  for (const JsonMember& member : object) {
    const auto found = keys.find(member.name);
    if (found == keys.end()) {
      std::vector<std::string_view> names;
      for (const auto& entry : keys) names.push_back(entry.first);
      parser::Diagnostic& diagnostic =
          lenient ? diagnostics.warning(member.name_span,
                                        fmt::format("unknown {} '{}' has no effect", noun, member.name))
                  : diagnostics.error(member.name_span, fmt::format("unknown {} '{}'", noun, member.name));
      diagnostic.suggestion = parser::closest(member.name, names);
    } else if (!found->second.take(member.value)) {
      diagnostics.error(member.value.span, fmt::format("'{}' takes {}", member.name, found->second.expects));
    }
  }
}

}  // namespace trace
