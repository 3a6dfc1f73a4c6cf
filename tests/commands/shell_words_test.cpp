// A command line as a shell would take it: what results say they were made by.
#include "tools/trace/shell_words.hpp"

#include <catch2/catch.hpp>

#include "tests/support/temporary_folder.hpp"

namespace trace::test {
namespace {

std::string line_of(const std::vector<const char*>& words) {
  return command_line(static_cast<int>(words.size()), words.data());
}

}  // namespace

TEST_CASE("harmless words of a command line stay as they are") {
  CHECK(line_of({"study", "-w", "16", "--axes=a,b", "../x_1.ray", "50%"}) ==
        "trace study -w 16 --axes=a,b ../x_1.ray 50%");
}

TEST_CASE("a word that a shell would change is quoted, an empty one too") {
  CHECK(line_of({"a b"}) == "trace 'a b'");
  CHECK(line_of({"*.ray", "$HOME"}) == "trace '*.ray' '$HOME'");
  CHECK(line_of({""}) == "trace ''");
  CHECK(line_of({"it's"}) == "trace 'it'\\''s'");
}

TEST_CASE("a shell makes the same words of the line again") {
  const TemporaryFolder folder;
  const std::vector<const char*> words{"a b", "",  "it's", "$x `y` \"z\"", "*", "line\nend", "\\",
                                       "!",   "~", "#c"};
  const std::string line = line_of(words).substr(5);  // without "trace"
  const std::string command =
      "cd '" + folder.path().string() + "' && for word in" + line + "; do printf '%s|' \"$word\"; done >out";
  REQUIRE(std::system(command.c_str()) == 0);
  std::string expected;
  for (const char* word : words) expected += std::string(word) + "|";
  CHECK(read_text(folder / "out") == expected);
}

}  // namespace trace::test
