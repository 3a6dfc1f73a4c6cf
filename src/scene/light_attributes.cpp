#include "scene/light_attributes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/unit_vector.hpp"

namespace trace {

bool LightAttributes::has_any(Words words) const {
  return std::any_of(words.begin(), words.end(), [this](std::string_view word) { return has(word); });
}

const LightAttributes::Attribute* LightAttributes::one_of(Words words) {
  const Attribute* first = nullptr;
  for (const Attribute& attribute : light_.attributes) {
    if (std::find(words.begin(), words.end(), attribute.word) == words.end()) continue;
    used_.insert(attribute.word);
    if (first) {
      diagnostics_
          .error(attribute.span, fmt::format("'{}' says again what '{}' says", attribute.word, first->word))
          .notes.push_back({first->span, "given here"});
      return nullptr;
    }
    first = &attribute;
  }
  return first;
}

const LightAttributes::Attribute* LightAttributes::needed(Words words) {
  const Attribute* found = one_of(words);
  if (!found && !has_any(words)) missing(fmt::format("'{}'", *words.begin()));
  return found;
}

void LightAttributes::missing(std::string_view what) {
  diagnostics_.error(light_.keyword, fmt::format("{} has no {}", light_.word, what));
}

std::optional<double> LightAttributes::number(const Attribute* attribute) {
  if (!attribute) return std::nullopt;
  if (const double* value = std::get_if<double>(&attribute->value)) return *value;
  error(*attribute, "takes one number");
  return std::nullopt;
}

std::optional<Vec3> LightAttributes::vector(const Attribute* attribute) {
  if (!attribute) return std::nullopt;
  if (const auto* value = std::get_if<std::array<double, 3>>(&attribute->value)) {
    return Vec3((*value)[0], (*value)[1], (*value)[2]);
  }
  error(*attribute, "takes three numbers");
  return std::nullopt;
}

std::optional<double> LightAttributes::leading_number(const Attribute* attribute) {
  if (!attribute || std::holds_alternative<double>(attribute->value)) return number(attribute);
  const auto& value = std::get<std::array<double, 3>>(attribute->value);
  if (value[1] != 0 || value[2] != 0) {
    warning(*attribute, fmt::format("only the first number of '{}' counts", attribute->word));
  }
  return value[0];
}

std::optional<double> LightAttributes::positive(const Attribute* attribute) {
  const std::optional<double> value = number(attribute);
  if (!value || *value > 0) return value;
  error(*attribute, "must be greater than 0");
  return std::nullopt;
}

std::optional<double> LightAttributes::not_negative(const Attribute* attribute) {
  const std::optional<double> value = number(attribute);
  if (!value || *value >= 0) return value;
  error(*attribute, "must not be negative");
  return std::nullopt;
}

std::optional<Vec3> LightAttributes::direction(const Attribute* attribute) {
  const std::optional<Vec3> value = vector(attribute);
  if (!value) return std::nullopt;
  const Vec3 direction = unit_vector(*value).direction;
  if (is_finite(direction) && !is_zero(*value)) return direction;
  error(*attribute, "must be longer than 0");
  return std::nullopt;
}

void LightAttributes::error(const Attribute& attribute, std::string text) {
  diagnostics_.error(attribute.value_span, fmt::format("'{}' {}", attribute.word, text));
}

void LightAttributes::warning(const Attribute& attribute, std::string text) {
  diagnostics_.warning(attribute.value_span, std::move(text));
}

void LightAttributes::warn_of_unused() {
  for (const Attribute& attribute : light_.attributes) {
    if (used_.contains(attribute.word)) continue;
    diagnostics_.warning(attribute.span,
                         fmt::format("'{}' has no effect in this {}", attribute.word, light_.word));
  }
}

}  // namespace trace
