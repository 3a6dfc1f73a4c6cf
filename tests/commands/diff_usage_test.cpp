// `trace diff`: command lines that cannot be used, and how the program starts.
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <catch2/catch.hpp>

#include <algorithm>

#include "tests/commands/diff_desk.hpp"

namespace trace::test {
namespace {

constexpr const char* hint = "\nRun 'trace diff --help' for how to use it.\n";

}  // namespace

TEST_CASE("a command line that cannot be used: status 4") {
  const DiffDesk desk;
  desk.put("a.png", 0);
  const auto error = [&](const std::string& arguments) {
    const Outcome outcome = desk.diff(arguments);
    CHECK(outcome.status == 4);
    CHECK(outcome.output.empty());
    CHECK_THAT(outcome.errors, Catch::StartsWith("trace: error: ") && Catch::EndsWith(hint));
    return outcome.errors.substr(14, outcome.errors.size() - 14 - std::string_view(hint).size());
  };
  CHECK(error("") == "A is required");
  CHECK(error("a.png") == "B is required");
  CHECK(error("a.png a.png --rmse -1") == "--rmse: '-1' is not a number that is not negative");
  CHECK(error("a.png a.png --max nan") == "--max: 'nan' is not a number that is not negative");
  CHECK(error("a.png a.png --pixels 101") == "--pixels: '101' is not a number from 0 to 100");
  CHECK(error("a.png a.png --over 2") == "--over requires --pixels");
  CHECK(error("a.png a.png --max 2 --tolerances t.json") ==
        "give tolerances on the command line or by --tolerances, not both");
  CHECK(error("a.png a.png --update --tolerances t.json") ==
        "--update needs --reason 'why this is accepted'");
  CHECK(error("a.png a.png --update --reason r") == "--update of two pictures needs --tolerances FILE");
  CHECK(error("a.png a.png --reason r") == "--reason is for --update");
  CHECK(error("a.png a.png --update --reason r --max 2") ==
        "--update writes the tolerance file, which tolerances on the command line replace");
  CHECK(error("a.png a.png --json - --csv -") ==
        "only one of --json, --csv and --junit can go to standard output");
  CHECK(error("a.png a.png -o a.png") == "the heat map would replace 'a.png', which is to be compared");
}

TEST_CASE("no result takes the place of what is compared, of the tolerances or of another result: status 4") {
  const DiffDesk desk;
  desk.put("a.png", 0);
  desk.put("b.png", 9);
  desk.put("A/x.png", 0);
  desk.put("B/x.png", 0);
  std::filesystem::create_symlink("a.png", desk / "link.png");
  std::filesystem::create_symlink("B", desk / "link");
  write_text(desk / "A/tolerances.json", "{}");
  const std::string a = read_text(desk / "a.png"), b = read_text(desk / "B/x.png");
  const auto error = [&](const std::string& arguments) {
    const Outcome outcome = desk.diff(arguments);
    CHECK(outcome.status == 4);
    return outcome.errors.substr(0, outcome.errors.find('\n'));
  };
  for (const std::string option : {"--json", "--csv", "--junit"}) {
    CHECK(error("a.png b.png -q " + option + " a.png") ==
          "trace: error: " + option + " would replace 'a.png', which is to be compared");
    CHECK(error("b.png a.png " + option + " A/../link.png") ==
          "trace: error: " + option + " would replace 'A/../link.png', which is to be compared");
    CHECK(error("A B " + option + " link/x.png") ==
          "trace: error: " + option + " would replace 'link/x.png', which is to be compared");
    CHECK(error("A B " + option + " A/tolerances.json") ==
          "trace: error: " + option + " would replace 'A/tolerances.json', which holds the tolerances");
    CHECK(error("a.png b.png -o new.png " + option + " A/../new.png") ==
          "trace: error: " + option + " would replace 'A/../new.png', which is the heat map's");
  }
  CHECK(error("A B --json r --junit ./r") == "trace: error: --junit would replace './r', which is --json's");
  CHECK(read_text(desk / "a.png") == a);
  CHECK(read_text(desk / "B/x.png") == b);
  CHECK(read_text(desk / "A/tolerances.json") == "{}");
  CHECK(!desk.has("new.png"));
  CHECK(desk.diff("A B --json /dev/null --csv /dev/null").status == 0);
}

TEST_CASE("a picture and a folder are not compared; the picture in it may be meant") {
  const DiffDesk desk;
  desk.put("a.png", 0);
  desk.put("B/a.png", 0);
  const Outcome outcome = desk.diff("a.png B");
  CHECK(outcome.status == 4);
  CHECK(outcome.errors ==
        "trace: error: 'B' is a folder and 'a.png' is not: give two pictures or two folders\n"
        "did you mean 'B/a.png'?\n"
        "Run 'trace diff --help' for how to use it.\n");
  CHECK(desk.diff("B a.png").status == 4);
  const Outcome missing = desk.diff("B nothing");
  CHECK(missing.status == 3);
  CHECK(missing.errors == "trace: error: cannot read 'nothing': no such file\n");
}

TEST_CASE("help goes to standard output: status 0") {
  const Outcome outcome = DiffDesk().diff("--help");
  CHECK(outcome.status == 0);
  CHECK(outcome.errors.empty());
  CHECK_THAT(outcome.output,
             Catch::Contains("trace diff [OPTIONS] A B") && Catch::Contains("Exit status: 0"));
}

TEST_CASE("comparing PNG files does not load OpenImageIO") {
  const DiffDesk desk;
  for (const std::string name : {"a.png", "b.png", "a.tif", "b.tif"}) desk.put(name, name[0]);
  const auto loaded = [&](const std::string& files) {
    const std::string command = "cd '" + desk.folder.path().string() +
                                "' && LD_DEBUG=files '" TRACE_PROGRAM "' diff " + files + " -q 2>loaded";
    CHECK(WEXITSTATUS(std::system(command.c_str())) == 1);
    return read_text(desk / "loaded");
  };
  CHECK_THAT(loaded("a.png b.png"), Catch::Contains("libc.so") && !Catch::Contains("OpenImageIO"));
  CHECK_THAT(loaded("a.tif b.tif"), Catch::Contains("OpenImageIO"));
}

#ifndef __SANITIZE_ADDRESS__
TEST_CASE("comparing two small PNG files takes less than 5 ms of processor time, start and end included") {
  const DiffDesk desk;
  desk.put("a.png", 0);
  desk.put("b.png", 9);
  std::string a = (desk / "a.png").string(), b = (desk / "b.png").string();
  double least = 1e9;
  for (int i = 0; i < 30; ++i) {
    std::string program = TRACE_PROGRAM, diff = "diff", quiet = "-q";
    char* arguments[] = {program.data(), diff.data(), a.data(), b.data(), quiet.data(), nullptr};
    pid_t child = 0;
    REQUIRE(posix_spawn(&child, TRACE_PROGRAM, nullptr, nullptr, arguments, nullptr) == 0);
    int status = 0;
    rusage usage{};
    REQUIRE(wait4(child, &status, 0, &usage) == child);
    REQUIRE(WEXITSTATUS(status) == 1);
    const auto milliseconds = [](const timeval& t) {
      return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_usec) / 1e3;
    };
    least = std::min(least, milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime));
  }
  CHECK(least < 5);
}
#endif

}  // namespace trace::test
