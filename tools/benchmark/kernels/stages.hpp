// The stages, each a subcommand of bench_kernels. They print a line a measurement, words of key=value; times
// are in milliseconds. They throw std::runtime_error where a scene cannot be read.
#pragma once

#include <string>
#include <vector>

namespace trace::bench {

struct ParseArguments {
  std::string scene;
  int repetitions = 5;
  bool numbers_alone = false;  // the anchor instead: std::from_chars over the numbers of the file
};
void measure_parse(const ParseArguments& arguments);

struct BuildArguments {
  std::string scene;
  std::vector<int> threads{1, 2};
  int repetitions = 5;
};
void measure_build(const BuildArguments& arguments);

struct RayArguments {
  std::string scene;
  int width = 1024;
  int repetitions = 3;
  std::vector<std::string> modes;       // empty: all
  std::vector<std::string> interfaces;  // "single", "coherent"; empty: both
};
void measure_rays(const RayArguments& arguments);

struct PngArguments {
  std::string scene;
  std::string output;
  std::vector<int> widths{512, 2048};
  int repetitions = 9;
};
void measure_png(const PngArguments& arguments);

// How many times as fast as one thread two are with arithmetic alone.
void measure_threads(int repetitions);

// Runs the commands that standard input gives, one a line, words parted by tabs, in turns.
void measure_processes(int rounds);

}  // namespace trace::bench
