#include "tools/trace/diff/picture_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "image/format.hpp"

namespace trace {
namespace {

namespace fs = std::filesystem;

struct Found {
  std::string extension;  // in lower case
  fs::path file;
};

// Of one name, sorted by extension.
struct Candidates {
  std::vector<Found> reference, test;
};
using CandidatesByName = std::map<std::string, Candidates>;

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  return text;
}

// Formats that are read though they are not written have their extensions here.
bool is_picture(const fs::path& file) {
  static constexpr std::string_view only_read[] = {".pbm", ".pgm", ".pfm", ".jp2",
                                                   ".j2k", ".dds", ".psd", ".targa"};
  const std::string extension = lower_case(file.extension().string());
  return format_of_extension(extension) || std::ranges::find(only_read, extension) != std::end(only_read);
}

bool is_hidden(const fs::path& file) {
  return file.filename().native().starts_with('.');
}

bool is_heat_map(const fs::path& file) {
  return lower_case(file.stem().extension().string()) == ".heat";
}

void collect(const fs::path& folder, std::vector<Found> Candidates::*side, CandidatesByName& all) {
  for (auto entry = fs::recursive_directory_iterator(folder); entry != fs::recursive_directory_iterator();
       ++entry) {
    const fs::path& file = entry->path();
    if (is_hidden(file)) {
      if (entry->is_directory()) entry.disable_recursion_pending();
      continue;
    }
    if (!is_picture(file) || is_heat_map(file) || entry->is_directory()) continue;
    fs::path name = file.lexically_relative(folder);
    name.replace_extension();
    (all[name.generic_string()].*side).push_back({lower_case(file.extension().string()), file});
  }
}

PicturePair matched(const Found& reference, const Found& test) {
  return {"", "", reference.file, test.file, ""};
}

// Takes those of the same extension out of both sides.
std::vector<PicturePair> take_equal_extensions(Candidates& candidates) {
  std::vector<PicturePair> pairs;
  std::erase_if(candidates.reference, [&](const Found& reference) {
    const auto same = std::ranges::find(candidates.test, reference.extension, &Found::extension);
    if (same == candidates.test.end()) return false;
    pairs.push_back(matched(reference, *same));
    candidates.test.erase(same);
    return true;
  });
  return pairs;
}

std::string ambiguity(const std::vector<Found>& others) {
  if (others.size() < 2) return "";
  return fmt::format("cannot tell which belongs to it: {} or {}", others[0].file.filename().string(),
                     others[1].file.filename().string());
}

std::vector<PicturePair> pairs_of(Candidates candidates) {
  std::ranges::sort(candidates.reference, {}, &Found::extension);
  std::ranges::sort(candidates.test, {}, &Found::extension);
  std::vector<PicturePair> pairs = take_equal_extensions(candidates);
  const auto& [references, tests] = candidates;
  if (references.size() == 1 && tests.size() == 1) {
    pairs.push_back(matched(references[0], tests[0]));
    return pairs;
  }
  for (const Found& reference : references)
    pairs.push_back({"", "", reference.file, std::nullopt, ambiguity(tests)});
  for (const Found& test : tests) pairs.push_back({"", "", std::nullopt, test.file, ambiguity(references)});
  return pairs;
}

}  // namespace

std::vector<PicturePair> pair_pictures(const fs::path& reference, const fs::path& test) {
  CandidatesByName all;
  collect(reference, &Candidates::reference, all);
  collect(test, &Candidates::test, all);
  std::vector<PicturePair> result;
  for (auto& [name, candidates] : all) {
    std::vector<PicturePair> pairs = pairs_of(std::move(candidates));
    for (PicturePair& pair : pairs) {
      pair.scene = pair.name = name;
      if (pairs.size() > 1) pair.name += (pair.reference ? *pair.reference : *pair.test).extension().string();
      result.push_back(pair);
    }
  }
  return result;
}

}  // namespace trace
