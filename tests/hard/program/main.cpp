// hard_cases: runs the hard cases with as many rays as wanted and writes what came of it. Exit status 1 where
// a promise is broken.
#include <CLI/CLI.hpp>
#include <chrono>
#include <fstream>
#include <iostream>

#include "tests/hard/program/table.hpp"

using namespace trace::hard;

namespace {

Result run(const HardCase& hard, double scale) {
  const auto begin = std::chrono::steady_clock::now();
  Result result{hard, hard.run(static_cast<std::uint64_t>(static_cast<double>(hard.full) * scale)), 0};
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

template <class Print>
bool write(const std::string& file, Print&& print) {
  if (file.empty()) return true;
  std::ofstream out(file);
  print(out);
  if (out.flush()) return true;
  std::cerr << "hard_cases: cannot write " << file << '\n';
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Runs the hard cases of the arithmetic.");
  double scale = 1;
  int row = 0;
  std::string json, markdown;
  bool digest = false;
  app.add_option("--rays-scale", scale, "Rays as a multiple of the full count")->check(CLI::PositiveNumber);
  app.add_option("--case", row, "Only the cases of this row");
  app.add_option("--json", json, "Write the results as JSON");
  app.add_option("--markdown", markdown, "Write the results as tables");
  app.add_flag("--digest", digest, "Print only what builds must have in common");
  CLI11_PARSE(app, argc, argv);

  std::vector<Result> results;
  bool kept = true;
  for (const HardCase& hard : hard_cases()) {
    if (row != 0 && hard.row != row) continue;
    results.push_back(run(hard, scale));
    kept = kept && failures_of(results.back().rows, ours) == 0;
    if (digest) {
      print_digests(std::cout, results.back());
    } else {
      print_lines(std::cout, results.back());
    }
    std::cout.flush();
  }
  const bool written = write(json, [&](std::ostream& out) { print_json(out, results); }) &&
                       write(markdown, [&](std::ostream& out) { print_markdown(out, results); });
  return kept && written ? 0 : 1;
}
