// The options --dialect and --permissive of the commands that draw scenes.
#pragma once

#include <CLI/CLI.hpp>

#include "rendering/options.hpp"

namespace trace {

// What is not given keeps its value.
void add_language_options(CLI::App& app, RenderOptions& options);

}  // namespace trace
