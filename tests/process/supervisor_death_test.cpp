#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "process/run_program.hpp"
#include "process/worker_pool.hpp"
#include "tests/process/pool_jobs.hpp"
#include "tests/support/temporary_folder.hpp"

namespace trace::test {
namespace {

// The process number in a file that is going to be written.
pid_t number_in(const std::filesystem::path& file) {
  const auto end = Clock::now() + long_enough;
  pid_t number = 0;
  while (!(std::ifstream(file) >> number) && Clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  REQUIRE(number > 0);
  return number;
}

// A job that runs a program, which runs another in a session of its own, for ever. Each writes its number to
// a file whose name begins with the job.
std::string run_for_ever(std::string_view job, const std::filesystem::path& folder) {
  const std::string name = std::string(job);
  std::ofstream(folder / (name + "-worker")) << getpid() << std::endl;
  ProgramOptions options;
  options.folder = folder;
  options.environment = {"name=" + name};
  run_program({"sh", "-c",
               "echo $$ > $name-program; setsid sh -c 'echo $$ > $name-other; exec sleep 1000' & sleep 1000"},
              options);
  return "";
}

std::vector<pid_t> numbers_of(const std::string& job, const std::filesystem::path& folder) {
  std::vector<pid_t> all;
  for (const char* who : {"-worker", "-program", "-other"}) all.push_back(number_in(folder / (job + who)));
  return all;
}

}  // namespace

TEST_CASE("nothing is left when the supervisor is killed, neither workers nor their programs") {
  const TemporaryFolder folder;
  const pid_t supervisor = fork();
  if (supervisor == 0) {
    try {
      WorkerPool pool(2,
                      [&](std::string_view job, BlobExchange&) { return run_for_ever(job, folder.path()); });
      pool.submit(1, "a");
      pool.submit(2, "b");
      for (;;) pool.wait(std::chrono::hours(1));
    } catch (...) {
    }
    _exit(1);
  }
  std::vector<pid_t> all = numbers_of("a", folder.path());
  for (pid_t other : numbers_of("b", folder.path())) all.push_back(other);
  for (pid_t process : all) CHECK(alive(process));
  kill(supervisor, SIGKILL);
  waitpid(supervisor, nullptr, 0);
  for (pid_t process : all) CHECK(soon_gone(process));
}

TEST_CASE("a job that is killed takes along the programs it runs") {
  const TemporaryFolder folder;
  WorkerPool pool(1, [&](std::string_view name, BlobExchange&) { return run_for_ever(name, folder.path()); });
  pool.submit(1, "job");
  pool.wait(std::chrono::milliseconds(0));
  const std::vector<pid_t> all = numbers_of("job", folder.path());
  for (pid_t process : all) CHECK(alive(process));
  pool.stop();
  for (pid_t process : all) CHECK(soon_gone(process));
}

TEST_CASE("a job may run a program under limits of its own") {
  const FinishedJob job = run_job(
      [](std::string_view, BlobExchange&) {
        ProgramOptions options;
        options.limits.timeout = std::chrono::milliseconds(100);
        return text(run_program({"sleep", "1000"}, options).outcome);
      },
      "", {long_enough, std::uint64_t{64} << 20});
  CHECK(job.answer == "ran out of time");
}

}  // namespace trace::test
