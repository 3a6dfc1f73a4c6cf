#include "tools/trace/tolerance_options.hpp"

#include "tools/trace/number_between.hpp"

namespace trace {

void ToleranceOptions::add_to(CLI::App& app) {
  const auto positive = number_between(0, 1e300, "a number that is not negative");
  const auto add = [&](const char* flag, std::optional<double>& target, const char* type,
                       const CLI::Validator& check, const char* description) {
    return app.add_option(flag, target, description)->check(check)->type_name(type)->group("Tolerance");
  };
  add("--rmse", rmse, "LEVELS", positive, "Root mean square error at most");
  add("--max", max, "LEVELS", positive, "Largest difference at most");
  CLI::Option* share = add("--pixels", pixels, "PERCENT", number_between(0, 100, "a number from 0 to 100"),
                           "Pixels off by more than --over at most");
  add("--over", over, "LEVELS", positive, "For --pixels (default: 1)")->needs(share);
  add("--ssim", ssim, "S", number_between(-1, 1, "a number from -1 to 1"),
      "Structural similarity at least (1 is equal)");
  add("--flip", flip, "F", number_between(0, 1, "a number from 0 to 1"), "FLIP at most (0 is equal)");
}

}  // namespace trace
