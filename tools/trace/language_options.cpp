#include "tools/trace/language_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/dialect_rules.hpp"

namespace trace {

void add_language_options(CLI::App& app, RenderOptions& options) {
  app.add_option_function<std::string>(
         "--dialect", [&options](const std::string& name) { options.dialect = *dialect_named(name); },
         "Whose rules the scene is drawn by where the courses differ: utexas, uw or hkust (default: utexas)")
      ->check(CLI::Validator(
          [](const std::string& name) {
            return dialect_named(name)
                       ? std::string()
                       : fmt::format("'{}' is none of {}", name, fmt::join(dialect_names, ", "));
          },
          ""))
      ->type_name("NAME");
  app.add_flag("--permissive", options.permissive,
               "Pass over unknown blocks, attributes and files that cannot be read, with a warning each");
}

}  // namespace trace
