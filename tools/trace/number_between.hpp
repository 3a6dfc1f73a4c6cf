// Checks of options that take real numbers. Unlike CLI::Range they refuse NaN.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <string>

namespace trace {

// What is refused is told as "'x' is not <description>".
inline CLI::Validator number_between(double low, double high, const std::string& description) {
  return CLI::Validator(
      [=](const std::string& text) {
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        const bool valid = !text.empty() && *end == '\0' && value >= low && value <= high;
        return valid ? std::string() : fmt::format("'{}' is not {}", text, description);
      },
      "");
}

// "a number from 0.01 to 255"; help shows the range too.
inline CLI::Validator number_between(double low, double high) {
  return number_between(low, high, fmt::format("a number from {} to {}", low, high))
      .description(fmt::format("FLOAT in [{} - {}]", low, high));
}

}  // namespace trace
