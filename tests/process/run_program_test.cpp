#include "process/run_program.hpp"

#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/process/pool_jobs.hpp"
#include "tests/support/temporary_folder.hpp"

namespace trace::test {
namespace {

ProgramResult shell(const std::string& script, const ProgramOptions& options = {}) {
  return run_program({"sh", "-c", script}, options);
}

ProgramOptions limited(double seconds, std::uint64_t megabytes = 0) {
  ProgramOptions options;
  options.limits = {std::chrono::duration<double>(seconds), megabytes << 20};
  return options;
}

Outcome exited(int status) {
  return {Outcome::Kind::exited, status};
}

}  // namespace

TEST_CASE("a program's output and status come back") {
  const ProgramResult result = shell("echo out; echo err >&2; exit 3");
  CHECK(result.outcome == exited(3));
  CHECK(text(result.outcome) == "exited with status 3");
  CHECK(result.output == "out\nerr\n");
  CHECK(result.errors.empty());
}

TEST_CASE("a program's errors are kept apart where that is asked for") {
  ProgramOptions options;
  options.errors_apart = true;
  const ProgramResult result = shell("echo out; echo err >&2", options);
  CHECK(result.output == "out\n");
  CHECK(result.errors == "err\n");
}

TEST_CASE("arguments reach a program as they are") {
  const ProgramResult result = run_program({"printf", "<%s>", "a b", "", "$HOME '*'", "\n"});
  CHECK(result.output == "<a b><><$HOME '*'><\n>");
}

TEST_CASE("a program has its folder and environment, and nothing to read") {
  const TemporaryFolder folder;
  ProgramOptions options;
  options.folder = folder.path();
  options.environment = {"COLOUR=dark red", "HOME=/nowhere"};
  const ProgramResult result = shell("pwd -P; echo \"$COLOUR $HOME\"; wc -c; test -n \"$PATH\"", options);
  CHECK(result.outcome == exited(0));
  CHECK(result.output == std::filesystem::canonical(folder.path()).string() + "\ndark red /nowhere\n0\n");
}

TEST_CASE("a program given by a relative path is found from our folder, not from its own") {
  const TemporaryFolder folder;
  ProgramOptions options;
  options.folder = folder.path();
  const auto program = std::filesystem::relative("/bin/sh");
  CHECK(run_program({program.string(), "-c", "exit 5"}, options).outcome == exited(5));
}

TEST_CASE("a program that cannot be started is told with the reason") {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "plain") << "text";
  const auto told = [](const ProgramResult& result) { return text(result.outcome); };
  CHECK(told(run_program({"no-such-program-anywhere"})) == "could not be started: no such file or directory");
  CHECK(told(run_program({(folder.path() / "plain").string()})) == "could not be started: permission denied");
  ProgramOptions options;
  options.folder = folder.path() / "missing";
  CHECK(told(shell("true", options)) == "could not be started: no such file or directory");
}

TEST_CASE("a program that crashes is told with its signal") {
  CHECK(shell("kill -SEGV $$").outcome == Outcome{Outcome::Kind::signalled, SIGSEGV});
  CHECK(shell("kill -KILL $$").outcome == Outcome{Outcome::Kind::signalled, SIGKILL});
}

TEST_CASE("a program that hangs is killed at its time limit, even if it will not be told") {
  const ProgramResult result = shell("trap '' TERM INT HUP; echo start; while :; do :; done", limited(0.5));
  CHECK(result.outcome.kind == Outcome::Kind::timed_out);
  CHECK(result.output == "start\n");
  CHECK(result.seconds >= 0.5);
  CHECK(result.seconds < long_enough.count());
  CHECK(result.cpu_seconds > 0);
}

TEST_CASE("nothing a program started is left when it has ended, not even in a session of its own") {
  const TemporaryFolder folder;
  ProgramOptions options;
  options.folder = folder.path();
  const std::string start_two =
      "sleep 1000 & echo $!; setsid sh -c 'echo $$ > number; exec sleep 1000' & "
      "while ! test -s number; do sleep 0.01; done; cat number; ";
  const auto both_gone = [](const std::string& numbers) {
    std::istringstream text(numbers);
    pid_t in_group = 0, in_session = 0;
    REQUIRE(text >> in_group >> in_session);
    return !alive(in_group) && !alive(in_session);
  };
  SECTION("by itself") {
    const ProgramResult result = shell(start_two + "exit 4", options);
    CHECK(result.outcome == exited(4));
    CHECK(both_gone(result.output));
  }
  SECTION("at its limit") {
    options.limits.timeout = std::chrono::seconds(1);
    const ProgramResult result = shell(start_two + "wait", options);
    CHECK(result.outcome.kind == Outcome::Kind::timed_out);
    CHECK(both_gone(result.output));
  }
}

TEST_CASE("a program that prints without end neither fills memory nor blocks") {
  const ProgramResult result = shell("echo begin; yes | head -c 200000000; echo end");
  CHECK(result.outcome == exited(0));
  CHECK(result.output.size() < 70'000);
  CHECK(result.output.substr(0, 8) == "begin\ny\n");
  CHECK(result.output.substr(result.output.size() - 4) == "end\n");
  CHECK(result.output.find("\n[... 199934474 bytes left out ...]\n") != std::string::npos);
}

TEST_CASE("a program that asks for too much memory is told to have run out of it") {
  // tail keeps a line without end.
  const ProgramResult result =
      shell("head -c 300000000 /dev/zero | tail -n 1 > /dev/null; exit 1", limited(0, 64));
  CHECK(result.outcome.kind == Outcome::Kind::out_of_memory);
}

TEST_CASE("the memory limit holds for all processes of a program together") {
  const std::string script =
      "grow() { x=aaaaaaaa; while test ${#x} -lt 8000000; do x=$x$x; done; sleep 1000; }; "
      "for i in 1 2 3 4 5 6 7 8; do grow & done; wait";
  const ProgramResult result = shell(script, limited(0, 64));
  CHECK(result.outcome.kind == Outcome::Kind::out_of_memory);
  CHECK(result.peak_memory_bytes > std::uint64_t{64} << 20);
}

TEST_CASE("a program's memory limit is its own, whatever our process uses") {
  const std::string ours(std::size_t{200} << 20, 'x');
  const ProgramResult result = shell("exit " + std::to_string(ours.back() == 'x'), limited(0, 64));
  CHECK(result.outcome == exited(1));
  CHECK(result.peak_memory_bytes < std::uint64_t{64} << 20);
}

TEST_CASE("a program cannot write a file without end") {
  const TemporaryFolder folder;
  ProgramOptions options;
  options.folder = folder.path();
  options.largest_file = 100'000;
  const ProgramResult result = shell("exec cat /dev/zero > file", options);
  CHECK(result.outcome == Outcome{Outcome::Kind::signalled, SIGXFSZ});
  CHECK(std::filesystem::file_size(folder.path() / "file") == 100'000);
}

TEST_CASE("the time a program's processes took is added up") {
  const ProgramResult result = shell("i=0; (while test $i -lt 30000; do i=$((i+1)); done) & wait");
  CHECK(result.cpu_seconds > 0.001);
  CHECK(result.seconds > 0.001);
}

TEST_CASE("running programs leaves neither processes nor open files behind") {
  const std::size_t before = open_files();
  shell("sleep 1000 & exit 0");
  run_program({"no-such-program-anywhere"});
  shell("sleep 1000", limited(0.1));
  CHECK(open_files() == before);
  CHECK(waitpid(-1, nullptr, WNOHANG) == -1);
}

TEST_CASE("a script without a first line that names its shell can be run") {
  const TemporaryFolder folder;
  const auto script = folder.path() / "my script";
  std::ofstream(script) << "echo \"$1\"; exit 6\n";
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  const ProgramResult result = run_program({script.string(), "a b"});
  CHECK(result.outcome == exited(6));
  CHECK(result.output == "a b\n");
}

}  // namespace trace::test
