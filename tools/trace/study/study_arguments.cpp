#include "tools/trace/study/study_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "tools/trace/language_options.hpp"
#include "tools/trace/exit_status.hpp"
#include "tools/trace/number_between.hpp"
#include "tools/trace/shell_words.hpp"

namespace trace {
namespace {

constexpr const char* study_examples = R"(Examples:
  trace study scene.ray                              times and errors over all settings
  trace study scenes/ --report study.html            all scenes of a folder, with a page to look at
  trace study scene.ray --axes samples,adaptive      some axes only
  trace study scenes/ --solutions sol --csv -        and errors against solution pictures, as a table

An error is the root mean square difference from the converged picture, in levels (1/255).
Exit status: 0 done, 1 a scene could not be studied, 2 usage, 3 cannot write.
)";

std::vector<std::string> axis_names() {
  std::vector<std::string> names;
  for (const AxisText& axis : axis_texts) names.emplace_back(axis.name);
  return names;
}

void add_what(CLI::App& app, StudyArguments& a) {
  app.add_option("scenes", a.scenes, "Scenes, or folders of them (with their batch.json)")->required();
  app.add_option("--solutions", a.solutions, "Errors against the pictures of this folder too")
      ->type_name("DIR");
  app.add_option("-r,--depth", a.options.depth,
                 "Bounces at most, also for the truth (default: as many as change anything)")
      ->check(CLI::Range(0, max_depth))
      ->type_name("N");
  app.add_option(
         "-w,--width", a.options.width,
         fmt::format("Width of the pictures in pixels (default: {}, or that of the solution)", study_width))
      ->check(CLI::Range(1, max_width))
      ->type_name("N");
  app.add_option("-j,--settings", a.settings,
                 "Settings as a JSON file; of antialiasing and blocks nothing counts")
      ->type_name("FILE");
  app.add_option("-c,--cubemap", a.cube_map, "One of six faces; the other five lie beside it")
      ->type_name("FACE");
  add_language_options(app, a.options);
  app.add_option("-t,--threads", a.options.threads, "Threads (default: one a processor)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  app.add_option("--seconds", a.seconds, "For measuring times, each scene")
      ->check(number_between(0, 1e6))
      ->capture_default_str()
      ->type_name("S");
}

void add_results(CLI::App& app, StudyArguments& a) {
  app.add_option("--report", a.report, "A page to look at: all results in one HTML file")->type_name("FILE");
  app.add_option("--json", a.json, "The results as JSON; - is standard output")->type_name("FILE");
  app.add_option("--csv", a.csv, "As a table, one row a scene and setting")->type_name("FILE");
  app.add_option("--svg", a.svg, "The plot over all scenes as a picture")->type_name("FILE");
  app.add_flag("-q,--quiet", a.quiet, "No progress, no warnings");
}

int refuse(const std::string& why) {
  fmt::print(stderr, "trace: error: {}\nRun 'trace study --help' for how to use it.\n", why);
  return exit_usage;
}

}  // namespace

std::optional<int> parse_study_arguments(int argc, const char* const* argv, StudyArguments& arguments) {
  CLI::App app("Measures what each setting costs and what it buys, on one scene or many.", "trace study");
  app.footer(study_examples);
  app.set_help_flag("-h,--help", "Show this and exit");
  arguments.command = command_line(argc, argv);
  arguments.options.width = study_width;
  add_what(app, arguments);
  std::vector<std::string> axes;
  app.add_option("--axes", axes, "What to vary (default: all)")
      ->check(CLI::IsMember(axis_names()))
      ->delimiter(',')
      ->type_name("NAME,...");
  add_results(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wish) {
    app.exit(wish);
    return exit_done;
  } catch (const CLI::ParseError& e) {
    return refuse(e.what());
  }
  for (const AxisText& axis : axis_texts) {
    if (axes.empty() || std::find(axes.begin(), axes.end(), axis.name) != axes.end())
      arguments.axes.push_back(axis.axis);
  }
  arguments.width_given = app.count("--width") > 0;
  arguments.depth_given = app.count("--depth") > 0;
  if ((arguments.json == "-") + (arguments.csv == "-") + (arguments.svg == "-") > 1)
    return refuse("only one of --json, --csv and --svg can go to standard output");
  if (arguments.report == "-") return refuse("--report needs a file, not standard output");
  return std::nullopt;
}

}  // namespace trace
