#include "tools/trace/diff/diff_command.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "image/image.hpp"
#include "process/large_pages.hpp"
#include "report/diff_csv.hpp"
#include "report/diff_json.hpp"
#include "report/diff_junit.hpp"
#include "tools/trace/diff/compare_pairs.hpp"
#include "tools/trace/diff/diff_arguments.hpp"
#include "tools/trace/diff/diff_text.hpp"
#include "tools/trace/diff/output_names.hpp"
#include "tools/trace/diff/tolerance_update.hpp"
#include "tools/trace/exit_status.hpp"
#include "tools/trace/text_output.hpp"
#include "tools/trace/tolerances.hpp"

namespace trace {
namespace {

namespace fs = std::filesystem;

int file_error(const std::string& text) {
  fmt::print(stderr, "trace: error: {}\n", text);
  return diff_file;
}

bool is_folder(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool exists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

// A folder cannot be compared with a picture; perhaps the picture of that name in it was meant.
int mixed_kinds(const DiffArguments& arguments, bool reference_is_folder) {
  const std::string& folder = reference_is_folder ? arguments.reference : arguments.test;
  const std::string& picture = reference_is_folder ? arguments.test : arguments.reference;
  std::string text =
      fmt::format("'{}' is a folder and '{}' is not: give two pictures or two folders", folder, picture);
  const std::string inside = (fs::path(folder) / fs::path(picture).filename()).string();
  if (exists(inside)) text += fmt::format("\ndid you mean '{}'?", inside);
  return diff_usage_error(text);
}

// The name by which a tolerance file knows a single picture: relative to that file where the picture is below
// its folder.
std::string scene_of(const std::string& picture, const std::string& tolerances) {
  fs::path name = fs::path(picture).filename();
  if (!tolerances.empty()) {
    std::error_code ignored;
    const fs::path folder = fs::weakly_canonical(tolerances, ignored).parent_path();
    const fs::path relative = fs::weakly_canonical(picture, ignored).lexically_relative(folder);
    if (!relative.empty() && *relative.begin() != "..") name = relative;
  }
  return name.replace_extension().generic_string();
}

struct Comparison {
  DiffArguments arguments;
  bool folders = false;
  std::vector<FilePair> pairs;
  DiffReport report;
  std::string notes;    // for people, behind the result
  bool unread = false;  // some folder could not be read, which has been said
};

void find_pairs(Comparison& comparison) {
  const DiffArguments& arguments = comparison.arguments;
  if (comparison.folders) {
    FolderPairs found = pair_pictures(arguments.reference, arguments.test);
    for (const UnreadableFolder& unread : found.unreadable)
      file_error(fmt::format("cannot read '{}': {}", unread.folder.string(), unread.reason));
    comparison.unread = !found.unreadable.empty();
    comparison.pairs = std::move(found.pairs);
    return;
  }
  const std::string scene = scene_of(arguments.reference, arguments.tolerances);
  comparison.pairs = {{scene, scene, arguments.reference, arguments.test, ""}};
}

// Pairs that are beyond tolerance become within; returns what the tolerance file then holds.
std::string accept(Comparison& comparison, const Tolerances& tolerances) {
  std::vector<AcceptedScene> accepted;
  for (std::size_t i = 0; i < comparison.pairs.size(); ++i) {
    Judgement& judgement = comparison.report.pairs[i].judgement;
    if (judgement.verdict != Verdict::beyond) continue;
    judgement.tolerance = accepting(judgement.tolerance, *judgement.measurements);
    judgement.verdict = Verdict::within;
    judgement.reason.clear();
    judgement.diagnosis.reset();
    accepted.push_back({comparison.pairs[i].scene, judgement.tolerance});
  }
  comparison.notes += fmt::format("accepted {} {} in {}\n", accepted.size(),
                                  accepted.size() == 1 ? "difference" : "differences", tolerances.path());
  return with_accepted(tolerances.text(), accepted, comparison.arguments.reason);
}

std::string human_text(const Comparison& comparison) {
  const bool colour = colour_wanted();
  const DiffReport& report = comparison.report;
  return (comparison.folders ? folder_text(report, colour) : pair_text(report.pairs.front(), colour)) +
         comparison.notes;
}

// Everything once the pairs are known. Throws ImageError for files that cannot be written.
int compare(Comparison& comparison) {
  const DiffArguments& arguments = comparison.arguments;
  std::vector<std::string_view> scenes;
  for (const FilePair& pair : comparison.pairs) scenes.push_back(pair.scene);
  const Tolerances tolerances({arguments.tolerance, arguments.tolerances,
                               comparison.folders ? arguments.reference : "", arguments.update},
                              scenes);
  if (!tolerances.messages().empty() && (!arguments.quiet || !tolerances.valid()))
    fmt::print(stderr, "{}", tolerances.messages());
  if (!tolerances.valid()) return diff_file;

  TextOutput json(arguments.json), csv(arguments.csv), junit(arguments.junit);
  TextOutput updated(arguments.update ? tolerances.path() : "");
  std::vector<std::string> failures;
  comparison.report = {arguments.reference, arguments.test,
                       compare_pairs(comparison.pairs, arguments, comparison.folders, tolerances, failures),
                       false};
  comparison.report.incomplete = comparison.unread || !failures.empty();
  if (arguments.update) updated.write(accept(comparison, tolerances));

  const bool data_on_output =
      json.is_standard_output() || csv.is_standard_output() || junit.is_standard_output();
  if (!arguments.quiet && !data_on_output) write_standard_output(human_text(comparison));
  if (json.wanted()) json.write(diff_json(comparison.report));
  if (csv.wanted()) csv.write(diff_csv(comparison.report));
  if (junit.wanted()) junit.write(diff_junit(comparison.report));
  for (const std::string& failure : failures) file_error(failure);
  return comparison.report.status();
}

// Two pictures of 512 x 512 with everything that is made of them take some 30 MB.
constexpr std::size_t heap_reserve = std::size_t{64} << 20;

int run(const DiffArguments& arguments) {
  use_large_pages(heap_reserve);
  const bool reference_is_folder = is_folder(arguments.reference), test_is_folder = is_folder(arguments.test);
  const bool folders = reference_is_folder || test_is_folder;
  if (folders && !(reference_is_folder && test_is_folder)) {
    const std::string& other = reference_is_folder ? arguments.test : arguments.reference;
    if (!exists(other)) return file_error(fmt::format("cannot read '{}': no such file", other));
    return mixed_kinds(arguments, reference_is_folder);
  }
  if (!folders && arguments.update && arguments.tolerances.empty())
    return diff_usage_error("--update of two pictures needs --tolerances FILE");
  Comparison comparison{arguments, folders, {}, {}, ""};
  find_pairs(comparison);
  if (const std::string text = output_conflict(arguments, folders, comparison.pairs); !text.empty())
    return diff_usage_error(text);
  if (comparison.pairs.empty()) {
    return file_error(
        fmt::format("there are no pictures in '{}' and '{}'", arguments.reference, arguments.test));
  }
  return compare(comparison);
}

}  // namespace

int diff_command(int argc, const char* const* argv) {
  const ParsedDiff parsed = parse_diff(argc, argv);
  if (parsed.status) return *parsed.status;
  try {
    return run(parsed.arguments);
  } catch (const fs::filesystem_error& e) {
    return file_error(fmt::format("cannot read '{}': {}", e.path1().string(), e.code().message()));
  } catch (const ImageError& e) {
    return file_error(e.what());
  } catch (const std::bad_alloc&) {
    return file_error("out of memory");
  }
}

}  // namespace trace
