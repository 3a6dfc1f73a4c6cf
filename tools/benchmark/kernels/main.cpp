// bench_kernels: the measurements that tools/bench asks for. It decides nothing: no goals, no comparisons.
#include <CLI/CLI.hpp>
#include <iostream>
#include <stdexcept>

#include "tools/benchmark/kernels/stages.hpp"

using namespace trace::bench;

namespace {

void add_scene(CLI::App& command, std::string& scene, int& repetitions) {
  command.add_option("scene", scene, "A .ray file")->required();
  command.add_option("--repetitions", repetitions, "Of each measurement")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Measures single stages of trace; see tools/bench.", "bench_kernels");
  app.require_subcommand(1);

  ParseArguments parse;
  CLI::App& parse_command = *app.add_subcommand("parse", "Text to description, one thread");
  add_scene(parse_command, parse.scene, parse.repetitions);
  parse_command.add_flag("--numbers-alone", parse.numbers_alone, "std::from_chars over the numbers instead");
  parse_command.callback([&] { measure_parse(parse); });

  BuildArguments build;
  CLI::App& build_command = *app.add_subcommand("build", "The hierarchies of the meshes");
  add_scene(build_command, build.scene, build.repetitions);
  build_command.add_option("--threads", build.threads, "Counts of threads")->delimiter(',');
  build_command.callback([&] { measure_build(build); });

  RayArguments rays;
  CLI::App& ray_command = *app.add_subcommand("rays", "Rays against the meshes, one thread");
  add_scene(ray_command, rays.scene, rays.repetitions);
  ray_command.add_option("--width", rays.width, "Of the frame in pixels");
  ray_command.add_option("--modes", rays.modes, "Of rays; see frame_rays.hpp")->delimiter(',');
  ray_command.add_option("--interfaces", rays.interfaces, "single, coherent")->delimiter(',');
  ray_command.callback([&] { measure_rays(rays); });

  PngArguments png;
  CLI::App& png_command = *app.add_subcommand("png", "Picture to PNG file");
  add_scene(png_command, png.scene, png.repetitions);
  png_command.add_option("output", png.output, "The file to write")->required();
  png_command.add_option("--widths", png.widths, "Of the pictures")->delimiter(',');
  png_command.callback([&] { measure_png(png); });

  int repetitions = 7;
  CLI::App& thread_command = *app.add_subcommand("threads", "Arithmetic alone on one thread and on two");
  thread_command.add_option("--repetitions", repetitions, "How often")->check(CLI::PositiveNumber);
  thread_command.callback([&] { measure_threads(repetitions); });

  int rounds = 1;
  CLI::App& process_command = *app.add_subcommand("processes", "Commands of standard input, in turns");
  process_command.add_option("--rounds", rounds, "How often each runs")->check(CLI::PositiveNumber);
  process_command.callback([&] { measure_processes(rounds); });

  try {
    app.parse(argc, argv);
  } catch (const CLI::Error& e) {
    return app.exit(e);
  } catch (const std::runtime_error& e) {
    std::cerr << "bench_kernels: " << e.what() << '\n';
    return 1;
  }
  return 0;
}
