#include "tools/trace/render/render_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <optional>

#include "image/openimageio.hpp"
#include "image/picture_file.hpp"
#include "loading/scene_loader.hpp"
#include "loading/settings_file.hpp"
#include "parallel/parallel.hpp"
#include "rendering/budget.hpp"
#include "tools/trace/language_options.hpp"
#include "tools/trace/exit_status.hpp"
#include "tools/trace/number_between.hpp"
#include "tools/trace/render/progress_line.hpp"
#include "tools/trace/render/statistics.hpp"
#include "tools/trace/text_output.hpp"
#include "tools/trace/version.hpp"

namespace trace {
namespace {

constexpr const char* examples = R"(Other commands:
  trace batch DIR -o OUT     all scenes of a folder, compared with solutions (trace batch --help)
  trace diff A B             two pictures, or two folders of them (trace diff --help)
  trace study SCENE...       what each setting costs and what it buys (trace study --help)

Examples:
  trace scene.ray out.png                      512 pixels wide, five bounces
  trace -r 8 -w 1024 scene.ray out.png         deeper and larger
  trace -j settings.json scene.ray out.png     antialiasing and other switches from a file
  trace -c sky/posx.png scene.ray out.png      the six faces in sky/ around the scene
  sed s/sphere/box/ a.ray | trace - out.png    a scene from standard input

Exit status: 0 done, 1 the scene or a file it needs is wrong, 2 usage, 3 cannot write.
)";

struct Arguments {
  std::string scene, output, settings, cube_map, stats_json;
  RenderOptions options;
  Budget budget;
  bool stats = false, quiet = false;
  bool depth_given = false, width_given = false, threads_given = false;
};

// What is wrong with the name, for the command line; "" for nothing.
std::string check_instruction_set(const std::string& name) {
  const auto set = instruction_set_named(name);
  if (!set) return fmt::format("'{}' is none of baseline, sse4, avx2 and avx512", name);
  if (*set > best_instruction_set()) return fmt::format("this machine does not have {}", name);
  return "";
}

void say(const Arguments& arguments, const std::string& text) {
  if (!arguments.quiet) fmt::print(stderr, "trace: {}\n", text);
}

// The settings file is applied after the flags, as the course's renderer does.
bool apply_settings(Arguments& arguments) {
  if (arguments.settings.empty()) return true;
  const SettingsFile file = read_settings(arguments.settings);
  if (!file.messages.empty() && (!arguments.quiet || !file.valid)) fmt::print(stderr, "{}", file.messages);
  if (!file.valid) return false;
  const RenderOptions flags = arguments.options;
  file.apply(arguments.options);
  const auto note = [&](bool given, int flag, int setting, const char* key, const char* option) {
    if (given && flag != setting) {
      say(arguments, fmt::format("note: \"{}\": {} in {} wins over {} {}", key, setting, arguments.settings,
                                 option, flag));
    }
  };
  note(arguments.depth_given, flags.depth, arguments.options.depth, "recursion_depth", "-r");
  note(arguments.width_given, flags.width, arguments.options.width, "size", "-w");
  note(arguments.threads_given, flags.threads, arguments.options.threads, "threads", "-t");
  return true;
}

// "error 0.62 levels as predicted (1 asked for): depth 5, 1.8 samples a pixel; 0.034 s".
std::string budget_text(const Budget& budget, const BudgetOutcome& outcome, double seconds) {
  const std::string asked = budget.error > 0 ? fmt::format("{:g} levels asked for", budget.error)
                                             : fmt::format("{:g} s asked for", budget.seconds);
  const bool met = outcome.met && (budget.error > 0 || seconds <= budget.seconds);
  return fmt::format("error {:.2g} levels as predicted ({}{}): depth {}, {:.2f} samples a pixel; {:.3f} s",
                     outcome.error(), asked, met ? "" : ", not met", outcome.depth, outcome.samples_per_pixel,
                     seconds);
}

// What writing the picture is expected to take: some 25 ns a pixel for PNG (docs/results/speed.md), and the
// file.
double seconds_to_write(const Scene& scene, const RenderOptions& options) {
  return 0.001 + 25e-9 * options.width * picture_height(scene, options.width);
}

// Both forms of the report, if they are asked for.
void report(const Statistics& statistics, const Arguments& arguments, TextOutput& json) {
  if (arguments.stats) fmt::print(stderr, "{}", to_text(statistics));
  if (json.wanted()) json.write(to_json(statistics));
}

int cannot_write(const std::string& problem) {
  fmt::print(stderr, "trace: error: {}\n", problem);
  return exit_cannot_write;
}

int run(Arguments& arguments) {
  StageClock clock;
  settle_openimageio(arguments.output, {arguments.scene, arguments.settings, arguments.cube_map});
  if (!apply_settings(arguments)) return exit_bad_input;
  std::optional<PictureFile> output;
  try {
    output.emplace(arguments.output);
  } catch (const ImageError& e) {
    return cannot_write(fmt::format("cannot write '{}': {}", arguments.output, e.what()));
  }
  clock.lap(Stage::start);

  FileImages images;
  LoadedScene loaded = load_scene(arguments.scene, arguments.options, images);
  if (!loaded.messages.empty() && (!arguments.quiet || !loaded.scene))
    fmt::print(stderr, "{}", loaded.messages);
  if (!loaded.scene) return exit_bad_input;
  Scene& scene = *loaded.scene;
  const std::string no_cube_map = add_cube_map(scene, arguments.cube_map, images);
  if (!arguments.quiet) fmt::print(stderr, "{}", no_cube_map);
  clock.lap(Stage::load);

  // Not sooner: up to here the program may start over (image/start_over.hpp).
  std::optional<TextOutput> stats_json;
  try {
    stats_json.emplace(arguments.stats_json);
  } catch (const ImageError& e) {
    return cannot_write(e.what());
  }
  const int threads = arguments.options.threads = threads_or_all(arguments.options.threads);
  const SceneTree tree(scene, threads, arguments.options.instruction_set,
                       arguments.options.shading.model_everything);
  clock.lap(Stage::build);

  Progress progress;
  Rendered rendered;
  std::optional<BudgetOutcome> outcome;
  {
    const ProgressLine line(progress, !arguments.quiet);
    if (arguments.budget.asked()) {
      Budget budget = arguments.budget;
      if (budget.seconds > 0) budget.seconds -= clock.seconds() + seconds_to_write(scene, arguments.options);
      WithinBudget within = render_within(budget, scene, tree, arguments.options, progress);
      rendered = std::move(within.rendered);
      outcome = within.outcome;
    } else {
      rendered = render(scene, tree, arguments.options, progress);
    }
  }
  clock.lap(Stage::render);

  try {
    output->write(rendered.image, threads);
  } catch (const ImageError& e) {
    return cannot_write(fmt::format("cannot write '{}': {}", arguments.output, e.what()));
  }
  clock.lap(Stage::write);
  if (rendered.non_finite.count > 0 && !arguments.quiet) {
    fmt::print(stderr, "{}: warning: {}\n", arguments.scene == "-" ? "<stdin>" : arguments.scene,
               to_text(rendered.non_finite));
  }
  if (outcome) say(arguments, budget_text(arguments.budget, *outcome, clock.seconds()));
  if (!arguments.stats && !stats_json->wanted()) return exit_done;
  try {
    report(statistics_of(clock, loaded, images, tree, arguments.options, rendered, arguments.output),
           arguments, *stats_json);
  } catch (const ImageError& e) {
    return cannot_write(e.what());
  }
  return exit_done;
}

}  // namespace

int render_command(int argc, const char* const* argv) {
  Arguments arguments;
  RenderOptions& options = arguments.options;
  CLI::App app("Renders a .ray scene (SBT-raytracer 1.0) to a picture.", "trace");
  app.footer(examples);
  app.set_version_flag("--version", version_text, "Show the version and exit");
  app.set_help_flag("-h,--help", "Show this and exit");
  auto* depth =
      app.add_option("-r,--depth", options.depth, "Bounces of reflection and refraction (0 to 1000)")
          ->check(CLI::Range(-max_depth, max_depth))
          ->capture_default_str()
          ->type_name("N");
  auto* width = app.add_option("-w,--width", options.width, "Width of the picture in pixels")
                    ->check(CLI::Range(1, max_width))
                    ->capture_default_str()
                    ->type_name("N");
  app.add_option("-j,--settings", arguments.settings, "Settings as a JSON file; they win over flags")
      ->type_name("FILE");
  app.add_option("-c,--cubemap", arguments.cube_map, "One of six faces; the other five lie beside it")
      ->type_name("FACE");
  add_language_options(app, options);
  auto* threads = app.add_option("-t,--threads", options.threads, "Threads (default: one a processor)")
                      ->check(CLI::Range(1, 1024))
                      ->type_name("N");
  Sampling& sampling = options.sampling;
  auto* aa = app.add_option("--aa", sampling.grid, "N x N samples in every pixel")
                 ->check(CLI::Range(1, max_grid))
                 ->type_name("N");
  auto* nine = app.add_flag("--nine-points", sampling.nine_points,
                            "The mean of nine points of every pixel: corners, middles of edges, centre");
  auto* adaptive = app.add_option("--adaptive", sampling.threshold,
                                  "Samples where they count, to an error of some so many levels in a pixel")
                       ->check(number_between(least_threshold, 255))
                       ->type_name("LEVELS");
  auto* error = app.add_option("--error-budget", arguments.budget.error,
                               "The fastest setting predicted to be off by at most so many levels (RMSE)")
                    ->check(number_between(least_error, 255))
                    ->type_name("LEVELS");
  auto* time = app.add_option("--time-budget", arguments.budget.seconds,
                              "The best picture predicted to take at most so long")
                   ->check(number_between(1e-3, 1e6))
                   ->type_name("SECONDS");
  aa->excludes(nine, adaptive, error, time);
  nine->excludes(adaptive, error, time);
  adaptive->excludes(error, time);
  error->excludes(time);
  std::string instruction_set;
  app.add_option("--instruction-set", instruction_set,
                 "baseline, sse4, avx2 or avx512 (default: the best there is; pictures are the same)")
      ->check(check_instruction_set)
      ->type_name("NAME");
  app.add_option("--least-contribution", options.shading.least_contribution,
                 "End paths of mirrored and refracted rays that carry less (0 to 1; 0: none)")
      ->check(number_between(0, 1))
      ->type_name("X");
  app.add_option("--light-samples", options.shading.light_samples,
                 "N x N shadows of each light that has a size, and rays of glossy surfaces")
      ->check(CLI::Range(1, max_light_samples))
      ->capture_default_str()
      ->type_name("N");
  std::string transmissive_shadows;
  app.add_option(
         "--transmissive-shadows", transmissive_shadows,
         "What glass leaves of light: by the distance inside (the course's rule), once a surface, or all "
         "(none: no shadow)")
      ->check(CLI::IsMember({"distance", "surface", "none"}))
      ->type_name("RULE");
  app.add_flag("--model-everything", options.shading.model_everything,
               "Everything is modelled, needed or not; the picture is the same, only slower");
  app.add_flag("--stats", arguments.stats,
               "Report on standard error: what was needed, done and left out, times and bytes");
  app.add_option("--stats-json", arguments.stats_json, "The same as JSON; - writes standard output")
      ->type_name("FILE");
  app.add_flag("-q,--quiet", arguments.quiet, "No notes, warnings or progress");
  app.add_option("scene", arguments.scene, "The scene; - reads standard input")->required();
  app.add_option("output", arguments.output,
                 "The picture: .png or .bmp; .jpg, .tif, .exr, ... by OpenImageIO")
      ->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wish) {
    app.exit(wish);
    return exit_done;
  } catch (const CLI::ParseError& e) {
    fmt::print(stderr, "trace: error: {}\nRun 'trace --help' for how to use it.\n", e.what());
    return exit_usage;
  }
  arguments.depth_given = depth->count() > 0;
  arguments.width_given = width->count() > 0;
  arguments.threads_given = threads->count() > 0;
  arguments.budget.fixed_depth = arguments.depth_given;
  if (options.depth < 0) options.depth = 0;
  options.shading.count_work = arguments.stats || !arguments.stats_json.empty();
  if (const auto rule = transmissive_shadows_named(transmissive_shadows)) {
    options.shading.transmissive_shadows = *rule;
  }
  if (const auto set = instruction_set_named(instruction_set)) options.instruction_set = *set;
  return run(arguments);
}

}  // namespace trace
