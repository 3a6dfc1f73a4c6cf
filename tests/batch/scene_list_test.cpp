// Which scenes a batch takes.
#include "batch/scene_list.hpp"

#include <catch2/catch.hpp>

#include "tests/support/temporary_folder.hpp"

namespace trace::test {

TEST_CASE("a pattern without a slash is for the file's name, wherever it lies") {
  CHECK(matches("box*", "box.ray"));
  CHECK(matches("box*", "simple/deep/box_1.ray"));
  CHECK(!matches("box*", "simple/my_box.ray"));
  CHECK(!matches("box*", "box/sphere.ray"));
  CHECK(matches("*", "a/b.ray"));
  CHECK(matches("[ab].ray", "x/b.ray"));
  CHECK(matches("?.ray", "x/b.ray"));
}

TEST_CASE("a pattern with a slash is for the whole path, and only ** goes over slashes") {
  CHECK(matches("simple/*", "simple/box.ray"));
  CHECK(!matches("simple/*", "simple/deep/box.ray"));
  CHECK(!matches("simple/*", "my/simple/box.ray"));
  CHECK(matches("simple/**", "simple/deep/box.ray"));
  CHECK(matches("**/box.ray", "simple/deep/box.ray"));
  CHECK(matches("**", "a/b/c.ray"));
}

TEST_CASE("a batch finds all scenes below its folder, in order of their names") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "b/c");
  std::filesystem::create_directories(folder / ".hidden");
  for (const char* file :
       {"z.ray", "a.ray", "b/m.ray", "b/c/deep.ray", "b/notes.txt", ".hidden/x.ray", ".dot.ray"})
    write_text(folder / file, "");
  std::filesystem::create_directory_symlink(folder / "b", folder / "link");
  using List = std::vector<std::string>;
  std::filesystem::create_symlink("loop.ray", folder / "loop.ray");
  CHECK(find_scenes(folder.path(), {}).problems.empty());
  CHECK(find_scenes(folder.path(), {}).scenes == List{"a.ray", "b/c/deep.ray", "b/m.ray", "z.ray"});
  CHECK(find_scenes(folder.path(), {{"b/*"}, {}}).scenes == List{"b/m.ray", "b/notes.txt"});
  CHECK(find_scenes(folder.path(), {{}, {"b/**", "z*"}}).scenes == List{"a.ray"});
}

}  // namespace trace::test
