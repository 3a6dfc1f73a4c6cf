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

// What is neither a file nor leads to one may never end when it is read.
bool is_device_or_pipe(const fs::directory_entry& entry) {
  std::error_code ignored;
  return entry.is_other(ignored);
}

// The pictures of one side.
class Collection {
 public:
  Collection(const fs::path& root, std::vector<Found> Candidates::*side, CandidatesByName& all)
      : root_(root), side_(side), all_(all) {
    std::error_code failed;
    for (pending_ = {root}; !pending_.empty();) {
      const fs::path folder = std::move(pending_.back());
      pending_.pop_back();
      fs::directory_iterator entry(folder, failed);
      if (failed && folder == root) throw fs::filesystem_error("cannot read", root, failed);
      for (; !failed && entry != fs::directory_iterator(); entry.increment(failed)) visit(*entry);
      if (failed) unreadable_.push_back({folder, failed.message()});
    }
    std::ranges::sort(unreadable_, {}, &UnreadableFolder::folder);
  }

  const std::vector<UnreadableFolder>& unreadable() const { return unreadable_; }

  // The folder that may hold the picture and could not be read.
  const UnreadableFolder* hiding(const std::string& name) const {
    const auto holds = [&](const UnreadableFolder& unread) {
      return unread.folder == root_ ||
             name.starts_with(unread.folder.lexically_relative(root_).generic_string() + "/");
    };
    const auto found = std::ranges::find_if(unreadable_, holds);
    return found == unreadable_.end() ? nullptr : &*found;
  }

 private:
  void visit(const fs::directory_entry& entry) {
    const fs::path& file = entry.path();
    std::error_code ignored;
    if (is_hidden(file)) return;
    if (entry.is_directory(ignored)) {
      if (!entry.is_symlink(ignored)) pending_.push_back(file);
      return;
    }
    if (!is_picture(file) || is_heat_map(file) || is_device_or_pipe(entry)) return;
    fs::path name = file.lexically_relative(root_);
    name.replace_extension();
    (all_[name.generic_string()].*side_).push_back({lower_case(file.extension().string()), file});
  }

  const fs::path& root_;
  std::vector<Found> Candidates::*side_;
  CandidatesByName& all_;
  std::vector<fs::path> pending_;
  std::vector<UnreadableFolder> unreadable_;
};

FilePair matched(const Found& reference, const Found& test) {
  return {"", "", reference.file, test.file, ""};
}

// Takes those of the same extension out of both sides.
std::vector<FilePair> take_equal_extensions(Candidates& candidates) {
  std::vector<FilePair> pairs;
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

std::vector<FilePair> pairs_of(Candidates candidates) {
  std::ranges::sort(candidates.reference, {}, &Found::extension);
  std::ranges::sort(candidates.test, {}, &Found::extension);
  std::vector<FilePair> pairs = take_equal_extensions(candidates);
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

FolderPairs pair_pictures(const fs::path& reference, const fs::path& test) {
  CandidatesByName all;
  const Collection references(reference, &Candidates::reference, all), tests(test, &Candidates::test, all);
  FolderPairs result{{}, references.unreadable()};
  result.unreadable.insert(result.unreadable.end(), tests.unreadable().begin(), tests.unreadable().end());
  for (auto& [name, candidates] : all) {
    std::vector<FilePair> pairs = pairs_of(std::move(candidates));
    for (FilePair& pair : pairs) {
      pair.scene = pair.name = name;
      if (pairs.size() > 1) pair.name += (pair.reference ? *pair.reference : *pair.test).extension().string();
      if (pair.note.empty() && !(pair.reference && pair.test))
        if (const auto* unread = (pair.reference ? tests : references).hiding(name))
          pair.note = fmt::format("cannot read '{}'", unread->folder.string());
      result.pairs.push_back(pair);
    }
  }
  return result;
}

}  // namespace trace
