#include "tools/trace/batch/batch_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <thread>

#include "tools/trace/language_options.hpp"
#include "tools/trace/exit_status.hpp"
#include "tools/trace/number_between.hpp"
#include "tools/trace/shell_words.hpp"
#include "tools/trace/tolerance_options.hpp"

namespace trace {
namespace {

constexpr const char* batch_examples = R"(Examples:
  trace batch scenes -o out                                    render all scenes below scenes/
  trace batch scenes -o out --solutions sol --report out/report.html
                                                               and compare, with a page to look at
  trace batch scenes -o out --include 'simple/*' -r 8          some of them, deeper
  trace batch scenes -o out --solutions sol --exec './ray -r {depth} -w {width} {scene} {out}'
                                                               another program instead, under the same limits
  trace batch scenes -o out --solutions sol --exec 'ann=ann/ray -r {depth} {scene} {out}' \
    --exec 'bob=bob/ray -r {depth} {scene} {out}'              a column for each

The same command again does only what is missing or has changed.
Exit status: 0 all rendered and within tolerance, 1 some beyond tolerance, 3 some not rendered, 4 usage;
128 + N where signal N interrupted it.
)";

void add_what(CLI::App& app, BatchArguments& a) {
  app.add_option("folder", a.folder, "The folder with the scenes, searched to the bottom")->required();
  app.add_option("-o,--output", a.output, "Where the pictures go, in folders as those of the scenes")
      ->required()
      ->type_name("DIR");
  app.add_option("--include", a.filter.include, "Only scenes that match (default: *.ray)")
      ->type_name("GLOB")
      ->take_all();
  app.add_option("--exclude", a.filter.exclude, "No scenes that match")->type_name("GLOB")->take_all();
}

void add_how(CLI::App& app, BatchArguments& a) {
  app.add_option("-r,--depth", a.options.depth, "Bounces of reflection and refraction (0 to 1000)")
      ->check(CLI::Range(-max_depth, max_depth))
      ->capture_default_str()
      ->type_name("N");
  app.add_option("-w,--width", a.options.width, "Width of the pictures in pixels")
      ->check(CLI::Range(1, max_width))
      ->capture_default_str()
      ->type_name("N");
  app.add_option("-j,--settings", a.settings, "Settings as a JSON file; they win over flags")
      ->type_name("FILE");
  app.add_option("-c,--cubemap", a.cube_map, "One of six faces; the other five lie beside it")
      ->type_name("FACE");
  add_language_options(app, a.options);
  app.add_option("-t,--threads", a.workers, "Scenes at a time (default: one a processor)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  app.add_option("--timeout", a.timeout, "Seconds for one scene")
      ->check(number_between(0.001, 1e6))
      ->capture_default_str()
      ->type_name("S");
  app.add_option("--memory", a.memory, "MiB for one scene (default: an equal share of 3/4 of the machine)")
      ->check(number_between(1, 1e6))
      ->type_name("MIB");
  app.add_option(
         "--exec", a.programs,
         "Render with this program; words {scene} {out} {depth} {width}; may be repeated, NAME=COMMAND "
         "gives it a name")
      ->type_name("COMMAND")
      ->take_all();
  app.add_flag("--fresh", a.fresh, "Do everything, also what is there from an earlier run");
}

void add_results(CLI::App& app, BatchArguments& a) {
  app.add_option("--solutions", a.solutions, "Compare with the pictures of this folder")->type_name("DIR");
  app.add_option("--tolerances", a.tolerances,
                 "What may differ, scene by scene (default: tolerances.json in the solutions' folder)")
      ->type_name("FILE");
  app.add_option("--report", a.report, "A page to look at: all results in one HTML file")->type_name("FILE");
  app.add_flag("--link-pictures", a.link_pictures,
               "The page names the picture files instead of holding them");
  app.add_option("--csv", a.csv, "The results as a table")->type_name("FILE");
  app.add_option("--junit", a.junit, "The results as JUnit's XML")->type_name("FILE");
  app.add_flag("-q,--quiet", a.quiet, "Errors only");
}

}  // namespace

std::optional<int> parse_batch_arguments(int argc, const char* const* argv, BatchArguments& arguments) {
  CLI::App app("Renders all scenes of a folder and compares them with solutions.", "trace batch");
  app.footer(batch_examples);
  app.set_help_flag("-h,--help", "Show this and exit");
  arguments.workers = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  arguments.command = command_line(argc, argv);
  add_what(app, arguments);
  add_how(app, arguments);
  add_results(app, arguments);
  ToleranceOptions limits;
  limits.add_to(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wish) {
    app.exit(wish);
    return batch_done;
  } catch (const CLI::ParseError& e) {
    fmt::print(stderr, "trace: error: {}\nRun 'trace batch --help' for how to use it.\n", e.what());
    return batch_usage;
  }
  arguments.options.depth = std::max(arguments.options.depth, 0);
  if (limits.given()) arguments.tolerance = limits.tolerance();
  const auto refuse = [](const char* why) {
    fmt::print(stderr, "trace: error: {}\nRun 'trace batch --help' for how to use it.\n", why);
    return batch_usage;
  };
  if (limits.given() && !arguments.tolerances.empty())
    return refuse("give tolerances on the command line or by --tolerances, not both");
  if (arguments.solutions.empty() && (limits.given() || !arguments.tolerances.empty()))
    return refuse("tolerances need --solutions to compare with");
  if (arguments.csv == "-" && arguments.junit == "-")
    return refuse("only one of --csv and --junit can go to standard output");
  if (arguments.report == "-") return refuse("--report needs a file, not standard output");
  return std::nullopt;
}

}  // namespace trace
