// `trace batch --exec`: what another program does wrong is told for what it is.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "tests/support/batch_folder.hpp"

namespace trace::test {
namespace {

// How many processes have this word in their command line.
int processes_with(const std::string& word) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "cmdline");  // words are ended by zeros
    const std::string line((std::istreambuf_iterator<char>(file)), {});
    count += line.find(word + '\0') != line.npos && line.find("sleep") == 0;
  }
  return count;
}

// One scene and its solution, and a script that draws it with our own program's arguments.
struct Course : BatchFolder {
  Course() {
    add_scene("a.ray", sphere);
    REQUIRE(run("scenes -o sol -w 40").status == 0);
  }
  Outcome grade(const std::string& script, const std::string& options = "") const {
    write_text(path() / "student", fmt::format("#!/bin/sh\n{}\n", script));
    std::filesystem::permissions(path() / "student", std::filesystem::perms::owner_all);
    return run(
        fmt::format("scenes -o out -w 40 --solutions sol --exec './student {{scene}} {{out}}' {}", options));
  }
  static std::string draw(const std::string& options = "-w 40") {
    return fmt::format("{} -q {} \"$1\" \"$2\"", TRACE_PROGRAM, options);
  }
};

}  // namespace

TEST_CASE("another program's right picture is as good as ours") {
  const Course course;
  const Outcome outcome = course.grade(Course::draw());
  CHECK(outcome.status == 0);
  CHECK(course.verdict("a.ray") == "identical");
  CHECK(std::filesystem::exists(course / "out/student/a.png"));
}

TEST_CASE("what a program does wrong has its own word and message") {
  const auto [script, word, message] = GENERATE(table<std::string, std::string, std::string>(
      {{"echo last words; kill -SEGV $$", "crashed",
        "scenes/a.ray: error: student crashed (segmentation fault)\nlast words\n"},
       {"echo cannot; exit 7", "failed", "scenes/a.ray: error: student exited with status 7\ncannot\n"},
       {"exit 0", "no-picture", "scenes/a.ray: error: student wrote no picture to {out}\n"},
       {Course::draw() + "; head -c 100 \"$2\" >half; mv half \"$2\"", "bad-picture",
        "scenes/a.ray: error: student wrote a picture that cannot be read: the PNG ends too early\n"},
       {Course::draw() + "; touch -d yesterday \"$2\"", "stale-picture",
        "scenes/a.ray: error: student left a picture that is older than its run: it has not drawn this "
        "one\n"}}));
  INFO(script);
  const Course course;
  const Outcome outcome = course.grade(script);
  CHECK(outcome.status == 3);
  CHECK(course.outcome("a.ray") == word);
  CHECK(course.message("a.ray") == message);
  CHECK_THAT(outcome.errors, Catch::EndsWith(message));
  CHECK(!std::filesystem::exists(course / "out/student/a.png"));
}

TEST_CASE("a program that hangs is stopped at its limit with all it has started") {
  const Course course;
  const Outcome outcome = course.grade("sleep 98765 & sleep 98765", "--timeout 1");
  CHECK(outcome.status == 3);
  CHECK(course.outcome("a.ray") == "timeout");
  CHECK(processes_with("98765") == 0);
}

TEST_CASE("a picture of the wrong size is a verdict, not a failure to draw") {
  const Course course;
  const Outcome outcome = course.grade(Course::draw("-w 20"));
  CHECK(outcome.status == 1);
  CHECK(course.outcome("a.ray") == "rendered");
  CHECK(course.verdict("a.ray") == "size-differs");
}

TEST_CASE("the picture of an earlier run is not graded after a crash") {
  const Course course;
  REQUIRE(course.grade(Course::draw()).status == 0);
  CHECK(course.grade("kill -ABRT $$").status == 3);
  CHECK(course.outcome("a.ray") == "crashed");
  CHECK(!std::filesystem::exists(course / "out/student/a.png"));
}

TEST_CASE("several programs are columns by their names") {
  const Course course;
  const std::string draw = fmt::format("{} -q -w {{width}} -r {{depth}} {{scene}} {{out}}", TRACE_PROGRAM);
  const Outcome outcome = course.run(
      fmt::format("scenes -o out -w 40 --solutions sol --exec 'ann={0}' --exec '{0}' --exec '{0}'", draw));
  CHECK(outcome.status == 0);
  CHECK(course.results("out").at("renderers") == nlohmann::json{"ann", "trace", "trace-2"});
  for (const char* name : {"ann", "trace", "trace-2"})
    CHECK(std::filesystem::exists(course / fmt::format("out/{}/a.png", name)));
}

TEST_CASE("file names with blanks and quotes reach the program whole") {
  const BatchFolder batch;
  batch.add_scene("it's a \"scene\".ray", sphere);
  const Outcome outcome = batch.run(
      fmt::format("scenes -o 'my out' -w 30 --exec 'x={} -w {{width}} {{scene}} {{out}}'", TRACE_PROGRAM));
  CHECK(outcome.status == 0);
  CHECK(std::filesystem::exists(batch / "my out/x/it's a \"scene\".png"));
}

TEST_CASE("a link in place of a picture is none") {
  const Course course;
  CHECK(course.grade("ln -s \"$PWD/sol/a.png\" \"$2\"").status == 3);
  CHECK(course.outcome("a.ray") == "bad-picture");
}

TEST_CASE("an edited script behind its interpreter is run again") {
  const Course course;
  const std::string command = "scenes -o out -w 40 --solutions sol --exec 'sh student {scene} {out}'";
  write_text(course / "student", Course::draw());
  REQUIRE(course.run(command).status == 0);
  REQUIRE(course.run(command).errors.empty());
  write_text(course / "student", "exit 3");
  CHECK(course.run(command).status == 3);
}

TEST_CASE("what a killed batch's programs left is cleared away by the next") {
  const Course course;
  std::filesystem::create_directories(course / "out/student/.trace-AbCdEf");
  write_text(course / "out/student/.trace-AbCdEf/a.png", "half");
  REQUIRE(course.grade(Course::draw()).status == 0);
  CHECK(course.names("out/student") == std::vector<std::string>{"a.png"});
}

}  // namespace trace::test
