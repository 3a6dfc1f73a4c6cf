// Which files of two folders are compared with one another.
#include "tools/trace/diff/picture_pairs.hpp"

#include <sys/stat.h>
#include <catch2/catch.hpp>

#include "tests/support/temporary_folder.hpp"

namespace trace::test {
namespace {

namespace fs = std::filesystem;

struct PairFolders {
  TemporaryFolder folder;
  PairFolders(const std::vector<std::string>& reference, const std::vector<std::string>& test) {
    fs::create_directories(folder / "A");
    fs::create_directories(folder / "B");
    for (const std::string& file : reference) put("A/" + file);
    for (const std::string& file : test) put("B/" + file);
  }
  void put(const std::string& file) const {
    fs::create_directories((folder / file).parent_path());
    write_text(folder / file, "");
  }
  // "name: file in A - file in B"
  std::vector<std::string> pairs() const {
    std::vector<std::string> result;
    for (const FilePair& pair : pair_pictures(folder / "A", folder / "B").pairs) {
      const auto file = [](const std::optional<fs::path>& path) {
        return path ? path->filename().string() : std::string("none");
      };
      result.push_back(pair.name + ": " + file(pair.reference) + " - " + file(pair.test));
    }
    return result;
  }
};

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("pictures belong together by relative path, extension apart, in the order of names") {
  const PairFolders folders({"b.png", "deep/er/x.png", "easy3.raise.png", "a.png"},
                            {"a.BMP", "b.png", "deep/er/x.exr", "easy3.raise.jpg", "deep/x.png"});
  CHECK(folders.pairs() == Lines{"a: a.png - a.BMP", "b: b.png - b.png", "deep/er/x: x.png - x.exr",
                                 "deep/x: none - x.png", "easy3.raise: easy3.raise.png - easy3.raise.jpg"});
}

TEST_CASE("of several pictures of one name those of the same extension belong together") {
  CHECK(PairFolders({"a.png"}, {"a.bmp", "a.png"}).pairs() ==
        Lines{"a.png: a.png - a.png", "a.bmp: none - a.bmp"});
  CHECK(PairFolders({"a.png", "a.exr"}, {"a.png", "a.hdr"}).pairs() ==
        Lines{"a.png: a.png - a.png", "a.exr: a.exr - a.hdr"});
}

TEST_CASE("which of two others belongs to a picture is not guessed") {
  const PairFolders folders({"a.png"}, {"a.bmp", "a.exr"});
  CHECK(folders.pairs() == Lines{"a.png: a.png - none", "a.bmp: none - a.bmp", "a.exr: none - a.exr"});
  const auto pairs = pair_pictures(folders.folder / "A", folders.folder / "B").pairs;
  CHECK(pairs[0].note == "cannot tell which belongs to it: a.bmp or a.exr");
  CHECK(pairs[0].scene == "a");
  CHECK(pairs[1].scene == "a");
}

TEST_CASE("hidden files, heat maps and files of other kinds are not compared") {
  const PairFolders folders({"a.png", "a.heat.png", ".b.png", ".git/c.png", "tolerances.json", "d.html", "e"},
                            {"a.png", "a.HEAT.PNG", "x/.trace-1.tmp", "a.json"});
  CHECK(folders.pairs() == Lines{"a: a.png - a.png"});
}

TEST_CASE("a folder whose name ends like a picture's is a folder") {
  CHECK(PairFolders({"a.png/b.png"}, {"a.png/b.png"}).pairs() == Lines{"a.png/b: b.png - b.png"});
}

TEST_CASE("a link that leads nowhere or in a circle is a picture; a pipe and a link to a folder are none") {
  const PairFolders folders({"a.png", "b.png", "sub/c.png"}, {});
  const fs::path test = folders.folder / "B";
  fs::create_symlink("nowhere.png", test / "a.png");
  fs::create_symlink("b.png", test / "b.png");
  fs::create_directory_symlink(folders.folder / "A/sub", test / "sub");
  fs::create_directory_symlink(folders.folder / "A/sub", test / "d.png");
  REQUIRE(mkfifo((test / "e.png").c_str(), 0600) == 0);
  CHECK(folders.pairs() == Lines{"a: a.png - a.png", "b: b.png - b.png", "sub/c: c.png - none"});
}

}  // namespace trace::test
