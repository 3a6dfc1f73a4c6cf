// The options by which a command line says what may differ.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "comparison/judge.hpp"

namespace trace {

// --rmse, --max, --pixels with --over, --ssim, --flip. Any of them replaces the defaults.
struct ToleranceOptions {
  std::optional<double> rmse, max, pixels, over, ssim, flip;

  void add_to(CLI::App& app);
  bool given() const { return rmse || max || pixels || ssim || flip; }
  Tolerance tolerance() const { return {rmse, max, pixels, over.value_or(1), ssim, flip}; }
};

}  // namespace trace
