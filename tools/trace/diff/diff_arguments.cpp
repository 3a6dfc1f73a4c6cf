#include "tools/trace/diff/diff_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "tools/trace/exit_status.hpp"
#include "tools/trace/number_between.hpp"
#include "tools/trace/tolerance_options.hpp"

namespace trace {
namespace {

constexpr const char* diff_examples =
    R"(Without tolerances: RMSE at most 0.5, at most 0.1 % of pixels off by more than 1 level.
One given on the command line replaces all of these. A level is 1/255 of full scale.

Examples:
  trace diff solution.png mine.png                 one picture
  trace diff -o heat.png solution.png mine.png     with a picture of where they differ
  trace diff solutions/ mine/ --json result.json   every picture below two folders
  trace diff --max 3 solutions/ mine/              no sample off by more than three levels
  trace diff solutions/ mine/ --update --reason 'new noise'
                                                   accept what differs, in solutions/tolerances.json

Exit status: 0 within tolerance, 1 beyond, 2 size or channels differ, 3 unreadable or missing, 4 usage.
)";

void add_files(CLI::App& app, DiffArguments& arguments) {
  const auto add = [&](const char* flags, std::string& target, const char* description) {
    return app.add_option(flags, target, description)->type_name("FILE");
  };
  add("--tolerances", arguments.tolerances,
      "Tolerances of each scene (default: tolerances.json in folder A)");
  app.add_flag("--update", arguments.update, "Accept the present differences in that file");
  app.add_option("--reason", arguments.reason, "Why they are accepted")->type_name("TEXT");
  add("-o,--heat-map", arguments.heat_map,
      "Where they differ, as a picture; for folders a folder of pictures");
  app.add_option("--amplify", arguments.amplify, "Make the heat map so many times more sensitive")
      ->check(number_between(1e-6, 1e6, "a number from 1e-6 to 1e6"))
      ->capture_default_str()
      ->type_name("F");
  add("--json", arguments.json, "The result as JSON; - is standard output");
  add("--csv", arguments.csv, "As a table, one row a pair");
  add("--junit", arguments.junit, "As JUnit's XML");
}

std::string contradiction(const DiffArguments& arguments, const ToleranceOptions& limits) {
  if (limits.given() && !arguments.tolerances.empty())
    return "give tolerances on the command line or by --tolerances, not both";
  if (limits.given() && arguments.update)
    return "--update writes the tolerance file, which tolerances on the command line replace";
  if (arguments.update && arguments.reason.empty()) return "--update needs --reason 'why this is accepted'";
  if (!arguments.update && !arguments.reason.empty()) return "--reason is for --update";
  if ((arguments.json == "-") + (arguments.csv == "-") + (arguments.junit == "-") > 1)
    return "only one of --json, --csv and --junit can go to standard output";
  return "";
}

}  // namespace

int diff_usage_error(const std::string& text) {
  fmt::print(stderr, "trace: error: {}\nRun 'trace diff --help' for how to use it.\n", text);
  return diff_usage;
}

ParsedDiff parse_diff(int argc, const char* const* argv) {
  ParsedDiff result;
  DiffArguments& arguments = result.arguments;
  ToleranceOptions limits;
  std::string metrics = "all";
  CLI::App app("Compares pictures with a reference and says how and where they differ.", "trace diff");
  app.footer(diff_examples);
  app.set_help_flag("-h,--help", "Show this and exit");
  app.add_option("A", arguments.reference, "The reference: a picture or a folder of them")->required();
  app.add_option("B", arguments.test, "What is compared with it")->required();
  limits.add_to(app);
  add_files(app, arguments);
  app.add_option("--metrics", metrics, "basic leaves out SSIM and FLIP unless a tolerance needs them")
      ->check(CLI::IsMember({"basic", "all"}))
      ->capture_default_str()
      ->type_name("SET");
  app.add_flag("-q,--quiet", arguments.quiet, "Print nothing; the exit status tells");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wish) {
    app.exit(wish);
    result.status = diff_within;
    return result;
  } catch (const CLI::ParseError& e) {
    result.status = diff_usage_error(e.what());
    return result;
  }
  if (limits.given()) arguments.tolerance = limits.tolerance();
  arguments.perceptual = metrics == "all";
  if (const std::string text = contradiction(arguments, limits); !text.empty())
    result.status = diff_usage_error(text);
  return result;
}

}  // namespace trace
