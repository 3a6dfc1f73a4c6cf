// Solution pictures by the names of their scenes.
#include "batch/solutions.hpp"

#include <catch2/catch.hpp>

#include "tests/support/temporary_folder.hpp"

namespace trace::test {
namespace {

// Empty files of these names; what is in them is not looked at.
struct SolutionFolder {
  TemporaryFolder folder;
  explicit SolutionFolder(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      std::filesystem::create_directories((folder / name).parent_path());
      write_text(folder / name, "");
    }
  }
  // From the folder; "" for none.
  std::string of(const std::string& scene) const {
    const std::filesystem::path found = Solutions(folder.path()).find(scene);
    return found.empty() ? "" : found.lexically_relative(folder.path()).string();
  }
};

}  // namespace

TEST_CASE("a solution has the path and name of its scene") {
  const SolutionFolder s({"a.png", "deep/er/b.png", "c.d.png"});
  CHECK(s.of("a.ray") == "a.png");
  CHECK(s.of("deep/er/b.ray") == "deep/er/b.png");
  CHECK(s.of("c.d.ray") == "c.d.png");
  CHECK(s.of("b.ray") == "");
  CHECK(s.of("deep/a.ray") == "");
  CHECK(s.of("c.ray") == "");
  CHECK(s.of("none/at/all.ray") == "");
}

TEST_CASE("of several kinds of picture PNG comes first, then BMP, then others") {
  CHECK(SolutionFolder({"a.bmp", "a.jpg", "a.png", "a.exr"}).of("a.ray") == "a.png");
  CHECK(SolutionFolder({"a.bmp", "a.exr", "a.jpg"}).of("a.ray") == "a.bmp");
  CHECK(SolutionFolder({"a.jpg", "a.exr"}).of("a.ray") == "a.exr");
  CHECK(SolutionFolder({"a.JPG"}).of("a.ray") == "a.JPG");
}

TEST_CASE("what is no picture is no solution") {
  CHECK(SolutionFolder({"a.txt", "a", "a.ray", "a.png.bak"}).of("a.ray") == "");
  CHECK(SolutionFolder({"A.png"}).of("a.ray") == "");
}

TEST_CASE("a folder that is not there has no solutions") {
  CHECK(Solutions("/no/such/folder").find("a.ray").empty());
}

}  // namespace trace::test
