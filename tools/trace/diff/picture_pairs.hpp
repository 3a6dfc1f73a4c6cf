// Which pictures of two folders belong together.
//
// By relative path, extension apart: A/simple/box.png and B/simple/box.bmp are "simple/box". Where a folder
// holds several pictures that differ only in extension, those of the same extension belong together; what is
// left over is a pair only where one is left on each side. Everything else has no partner, and several
// pictures of one name are told apart by their extension.
//
// Pictures are told by extension. Skipped are hidden files and folders, heat maps (*.heat.png), files of
// other kinds, devices and pipes, and what a symbolic link to a folder leads to. A symbolic link that leads
// nowhere, or in a circle, is a picture: one that cannot be read.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace trace {

struct FilePair {
  std::string name;   // "simple/box"; with its extension where another picture has that name
  std::string scene;  // "simple/box" in any case: what tolerances are given for
  std::optional<std::filesystem::path> reference, test;  // empty where there is no such file
  std::string note;  // why there is no partner, where that is not simply that there is no file
};

// A folder below one of the two of which not all entries are known.
struct UnreadableFolder {
  std::filesystem::path folder;
  std::string reason;
};

struct FolderPairs {
  std::vector<FilePair> pairs;               // in the order of their names
  std::vector<UnreadableFolder> unreadable;  // those of the reference first
};

// Throws std::filesystem::filesystem_error where one of the two themselves cannot be read.
FolderPairs pair_pictures(const std::filesystem::path& reference, const std::filesystem::path& test);

}  // namespace trace
