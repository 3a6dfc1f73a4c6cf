#include "tools/trace/diff/compare_pairs.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "image/image.hpp"
#include "parallel/parallel.hpp"

namespace trace {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> text(const std::optional<fs::path>& path) {
  return path ? std::optional(path->string()) : std::nullopt;
}

fs::path heat_map_of(const FilePair& pair, const DiffArguments& arguments, bool folders) {
  if (arguments.heat_map.empty() || !folders) return arguments.heat_map;
  return fs::path(arguments.heat_map) / (pair.name + ".heat.png");
}

// A pair without one of its pictures.
Judgement alone(const FilePair& pair, const DiffArguments& arguments, const Tolerance& tolerance) {
  Judgement judgement;
  judgement.tolerance = tolerance;
  judgement.verdict = pair.reference ? Verdict::missing : Verdict::extra;
  judgement.reason = pair.note.empty() ? fmt::format("there is none in {}",
                                                     pair.reference ? arguments.test : arguments.reference)
                                       : pair.note;
  return judgement;
}

// judge() writes no heat map where the pictures are equal or cannot be compared; none may look as if it were
// of this run.
void remove_old(const fs::path& heat_map) {
  std::error_code ignored;
  if (!heat_map.empty() && fs::is_regular_file(heat_map, ignored)) fs::remove(heat_map, ignored);
}

Judgement judged(const FilePair& pair, const DiffArguments& arguments, bool folders,
                 const Tolerance& tolerance, unsigned threads, std::string& failure) {
  const fs::path heat_map = heat_map_of(pair, arguments, folders);
  remove_old(heat_map);
  if (!pair.reference || !pair.test) return alone(pair, arguments, tolerance);
  JudgeOptions options{tolerance, arguments.perceptual, heat_map, arguments.amplify, threads};
  try {
    if (folders && !heat_map.empty()) fs::create_directories(heat_map.parent_path());
    return judge(*pair.reference, *pair.test, options);
  } catch (const ImageError& e) {
    failure = fmt::format("cannot write '{}': {}", heat_map.string(), e.what());
  } catch (const fs::filesystem_error& e) {
    failure = fmt::format("cannot write '{}': {}", heat_map.string(), e.code().message());
  }
  // The heat map is lost, the verdict is not.
  options.heat_map.clear();
  return judge(*pair.reference, *pair.test, options);
}

void check_heat_map(const DiffArguments& arguments, bool folders) {
  const std::string& name = arguments.heat_map;
  if (name.empty()) return;
  try {
    std::error_code ignored;
    if (!folders)
      check_writable(name);
    else if (fs::exists(name, ignored) && !fs::is_directory(name, ignored))
      throw ImageError("it is not a folder");
  } catch (const ImageError& e) {
    throw ImageError(fmt::format("cannot write '{}': {}", name, e.what()));
  }
}

}  // namespace

std::vector<ComparedPair> compare_pairs(const std::vector<FilePair>& pairs, const DiffArguments& arguments,
                                        bool folders, const Tolerances& tolerances,
                                        std::vector<std::string>& failures) {
  check_heat_map(arguments, folders);
  std::vector<ComparedPair> results(pairs.size());
  std::vector<std::string> failure(pairs.size());
  // One pair is divided between threads, several are given one each.
  const unsigned threads = pairs.size() == 1 ? JudgeOptions{}.threads : 1;
  const auto compare = [&](std::size_t i, int) {
    const FilePair& pair = pairs[i];
    ComparedPair& result = results[i];
    result = {pair.name, text(pair.reference), text(pair.test),
              judged(pair, arguments, folders, tolerances.of(pair.scene), threads, failure[i])};
    if (result.judgement.verdict == Verdict::missing) result.test.reset();
    if (result.judgement.verdict == Verdict::extra) result.reference.reset();
  };
  parallel_for(hardware_threads(), pairs.size(), compare);
  for (std::string& text_of_one : failure)
    if (!text_of_one.empty()) failures.push_back(std::move(text_of_one));
  return results;
}

}  // namespace trace
