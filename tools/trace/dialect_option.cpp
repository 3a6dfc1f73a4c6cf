#include "tools/trace/dialect_option.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/dialect_rules.hpp"

namespace trace {

void add_dialect_option(CLI::App& app, parser::Dialect& dialect) {
  app.add_option_function<std::string>(
         "--dialect", [&dialect](const std::string& name) { dialect = *dialect_named(name); },
         "Whose rules the scene is drawn by where the courses differ: utexas, uw or hkust (default: utexas)")
      ->check(CLI::Validator(
          [](const std::string& name) {
            return dialect_named(name)
                       ? std::string()
                       : fmt::format("'{}' is none of {}", name, fmt::join(dialect_names, ", "));
          },
          ""))
      ->type_name("NAME");
}

}  // namespace trace
