// The option --dialect of the commands that draw scenes.
#pragma once

#include <CLI/CLI.hpp>

#include "parser/description.hpp"

namespace trace {

// Sets `dialect`, which keeps its value where the option is not given.
void add_dialect_option(CLI::App& app, parser::Dialect& dialect);

}  // namespace trace
