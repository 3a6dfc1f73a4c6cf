// The batch.json files of a folder and of those below it, together.
#include "batch/batch_files.hpp"

#include <catch2/catch.hpp>

#include "tests/support/temporary_folder.hpp"

namespace trace::test {
namespace {

struct FolderOfFiles {
  TemporaryFolder folder;
  std::string messages;

  void write(const std::string& where, const std::string& text) const {
    std::filesystem::create_directories(folder / where);
    write_text(folder / where / "batch.json", text);
  }
  BatchFiles files() { return {folder.path(), messages}; }
};

}  // namespace

TEST_CASE("the file of a deeper folder wins, and what it does not say holds from above") {
  FolderOfFiles f;
  f.write("", R"({"default": {"width": 30, "depth": 3}})");
  f.write("a/b", R"({"scenes": {"c.ray": {"width": 20}}})");
  BatchFiles files = f.files();
  CHECK(files.of("x.ray")->width == 30);
  CHECK(files.of("a/x.ray")->width == 30);
  CHECK(files.of("a/b/c.ray")->width == 20);
  CHECK(files.of("a/b/c.ray")->depth == 3);
  CHECK(files.of("a/b/x.ray")->width == 30);
  CHECK(files.valid());
  CHECK(f.messages == "");
}

TEST_CASE("patterns of a file are on paths from its own folder") {
  FolderOfFiles f;
  f.write("", R"({"scenes": {"a/c.ray": {"depth": 1}}})");
  f.write("a", R"({"scenes": {"c.ray": {"width": 20}, "a/c.ray": {"width": 99}}})");
  BatchFiles files = f.files();
  CHECK(files.of("a/c.ray")->width == 20);
  CHECK(files.of("a/c.ray")->depth == 1);
  CHECK_FALSE(files.of("c.ray")->width.has_value());
}

TEST_CASE("a scene that any of the files excludes has no options") {
  FolderOfFiles f;
  f.write("", R"({"exclude": ["a/draft*"]})");
  f.write("a", R"({"exclude": ["old*"]})");
  BatchFiles files = f.files();
  CHECK_FALSE(files.of("a/draft_1.ray").has_value());
  CHECK_FALSE(files.of("a/old.ray").has_value());
  CHECK(files.of("old.ray").has_value());
  CHECK(files.of("draft_1.ray").has_value());
}

TEST_CASE("a folder without such files has nothing to say, but of its scenes none is excluded") {
  FolderOfFiles f;
  BatchFiles files = f.files();
  const auto options = files.of("a/b/c.ray");
  REQUIRE(options.has_value());
  CHECK_FALSE(options->width.has_value());
  CHECK(options->settings.empty());
  CHECK(files.valid());
}

TEST_CASE("what is wrong with a file is told once, when its first scene is asked for") {
  FolderOfFiles f;
  f.write("a", R"({"default": {"width": 0}})");
  BatchFiles files = f.files();
  files.of("b.ray");
  CHECK(files.valid());
  CHECK(f.messages == "");
  files.of("a/b.ray");
  CHECK_FALSE(files.valid());
  CHECK_THAT(f.messages, Catch::Contains("a/batch.json:1:23: error: 'width' takes a whole number"));
  const std::string once = f.messages;
  files.of("a/c.ray");
  CHECK(f.messages == once);
}

}  // namespace trace::test
