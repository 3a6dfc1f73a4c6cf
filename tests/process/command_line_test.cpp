#include "process/command_line.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace trace::test {
namespace {

using Words = std::vector<std::string>;

// The message and the position, as "7: message".
template <typename Attempt>
std::string error_of(Attempt attempt) {
  try {
    attempt();
  } catch (const CommandError& error) {
    return std::to_string(error.position()) + ": " + error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("a command is split at blanks outside quotes") {
  CHECK(parse_command("  ray -r 5\tscene.ray \n") == Words{"ray", "-r", "5", "scene.ray"});
  CHECK(parse_command("'my ray' \"a b\"c'd e' ''") == Words{"my ray", "a bcd e", ""});
}

TEST_CASE("quotes and backslashes in a command mean what they mean to the shell") {
  CHECK(parse_command(R"(a\ b \' \\)") == Words{"a b", "'", "\\"});
  CHECK(parse_command(R"("a\"b" "\$x" "\n" '\"')") == Words{"a\"b", "$x", "\\n", "\\\""});
  CHECK(parse_command("$HOME *.ray | less") == Words{"$HOME", "*.ray", "|", "less"});
}

TEST_CASE("an error in a command tells its place") {
  CHECK(error_of([] { parse_command("  "); }) == "0: the command is empty");
  CHECK(error_of([] { parse_command("ray 'a b"); }) == "4: the quote ' is not closed");
  CHECK(error_of([] { parse_command("ray x\"a b\\\""); }) == "5: the quote \" is not closed");
  CHECK(error_of([] { parse_command("ray \\"); }) == "4: a backslash with nothing behind it");
}

TEST_CASE("placeholders are replaced after splitting, so that values with blanks stay whole") {
  const std::vector<Placeholder> known = {{"scene", "my scene.ray"}, {"depth", "5"}};
  CHECK(fill_in(parse_command("ray -r{depth} {scene}"), known) == Words{"ray", "-r5", "my scene.ray"});
  CHECK(fill_in({"{{scene}} {{}} {scene}{depth}"}, known) == Words{"{scene} {} my scene.ray5"});
  CHECK(fill_in({"{scene}"}, {{"scene", "{depth}"}, {"depth", "5"}}) == Words{"{depth}"});
}

TEST_CASE("an unknown placeholder is an error that lists the known ones") {
  const std::vector<Placeholder> known = {{"scene", "s"}, {"out", "o"}};
  CHECK(error_of([&] { fill_in({"-w={size}"}, known); }) ==
        "3: unknown placeholder {size}: there are {scene}, {out}");
  CHECK(error_of([&] { fill_in({"{}"}, known); }) == "0: unknown placeholder {}: there are {scene}, {out}");
}

TEST_CASE("a brace alone in a command is an error") {
  CHECK(error_of([] { fill_in({"a{b"}, {}); }) == "1: a { alone: {{ stands for the brace itself");
  CHECK(error_of([] { fill_in({"ab}"}, {}); }) == "2: a } alone: }} stands for the brace itself");
}

}  // namespace trace::test
