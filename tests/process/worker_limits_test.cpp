#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "process/sanitizers.hpp"
#include "process/worker_pool.hpp"
#include "tests/process/pool_jobs.hpp"

namespace trace::test {
namespace {

constexpr std::uint64_t megabyte = std::uint64_t{1} << 20;

Limits memory(std::uint64_t megabytes) {
  return {std::chrono::duration<double>(0), megabytes * megabyte};
}
Limits seconds(double timeout) {
  return {std::chrono::duration<double>(timeout), 0};
}

}  // namespace

TEST_CASE("a job that hangs is killed at its time limit, and the others do not wait for it") {
  WorkerPool pool(2, [](std::string_view job, BlobExchange&) -> std::string {
    if (job == "sleep") pause();
    if (job == "spin") {
      for (std::atomic<int> turns = 0;;) ++turns;
    }
    return "well";
  });
  pool.submit(1, "sleep", seconds(0.2));
  pool.submit(2, "spin", seconds(0.2));
  for (JobId id = 3; id < 10; ++id) pool.submit(id, "", seconds(long_enough.count()));
  const auto all = finish_all(pool);
  for (JobId id : {1, 2}) {
    CHECK(all.at(id).outcome.kind == Outcome::Kind::timed_out);
    CHECK(all.at(id).seconds >= 0.2);
    CHECK(all.at(id).seconds < long_enough.count());
  }
  CHECK(all.at(2).cpu_seconds > 0);
  for (JobId id = 3; id < 10; ++id) CHECK(all.at(id).answer == "well");
}

TEST_CASE("a job that exhausts its memory is stopped, and the next job has all of its own") {
  WorkerPool pool(1, [](std::string_view job, BlobExchange&) -> std::string {
    if (job == "bomb") exhaust_memory();
    return std::to_string(std::string(48 * megabyte, 'x').find('y') == std::string::npos);
  });
  pool.submit(1, "bomb", memory(64));
  for (JobId id = 2; id < 6; ++id) pool.submit(id, "", memory(64));
  const auto all = finish_all(pool);
  CHECK(all.at(1).outcome.kind == Outcome::Kind::out_of_memory);
  CHECK(all.at(1).peak_memory_bytes < 2048 * megabyte);
  for (JobId id = 2; id < 6; ++id) CHECK(all.at(id).answer == "1");
}

TEST_CASE("memory that is written to counts where the limit on allocations does not hold") {
  // As in a process that lifts the limit, or that was built with a sanitizer.
  const FinishedJob job = run_job(
      [](std::string_view, BlobExchange&) -> std::string {
        rlimit none{RLIM_INFINITY, RLIM_INFINITY};
        setrlimit(RLIMIT_DATA, &none);
        exhaust_memory();
        return "";
      },
      "", memory(64));
  CHECK(job.outcome.kind == Outcome::Kind::out_of_memory);
  CHECK(job.errors.empty());
}

TEST_CASE("an allocation beyond the limit fails even where nothing is written to it") {
  if (built_with_sanitizer) return;  // there is no such limit then
  const FinishedJob job = run_job(
      [](std::string_view, BlobExchange&) {
        const auto untouched = std::make_unique_for_overwrite<char[]>(1024 * megabyte);
        return std::to_string(reinterpret_cast<std::uintptr_t>(untouched.get()));
      },
      "", memory(64));
  CHECK(job.outcome.kind == Outcome::Kind::out_of_memory);
  CHECK(job.peak_memory_bytes < 512 * megabyte);
}

TEST_CASE("a failed allocation in a function that may not throw is told as such") {
  if (built_with_sanitizer) return;
  const FinishedJob job = run_job(
      [](std::string_view, BlobExchange&) -> std::string {
        []() noexcept { exhaust_memory(); }();
        return "";
      },
      "", memory(64));
  CHECK(job.outcome.kind == Outcome::Kind::out_of_memory);
}

TEST_CASE("memory the supervisor holds is not counted against a job") {
  const std::string shared(256 * megabyte, 'x');
  const FinishedJob job = run_job(
      [&](std::string_view, BlobExchange&) {
        return std::to_string(std::string(16 * megabyte, 'y').size() + shared.size());
      },
      "", memory(64));
  CHECK(job.answer == std::to_string(272 * megabyte));
}

TEST_CASE("waiting is over when a signal comes") {
  WorkerPool pool(1, [](std::string_view, BlobExchange&) -> std::string {
    kill(getppid(), SIGUSR1);
    for (;;) pause();
  });
  static volatile std::sig_atomic_t came = 0;
  came = 0;
  std::signal(SIGUSR1, [](int) { came = 1; });
  pool.submit(1, "");
  const auto start = Clock::now();
  while (!came && Clock::now() - start < long_enough) CHECK(pool.wait(std::chrono::hours(1)).empty());
  CHECK(came == 1);
  CHECK(pool.running() == std::vector<JobId>{1});
  std::signal(SIGUSR1, SIG_DFL);
}

TEST_CASE("workers leave Ctrl-C to the supervisor") {
  const FinishedJob job = run_job([](std::string_view, BlobExchange&) -> std::string {
    raise(SIGINT);
    return "still here";
  });
  CHECK(job.answer == "still here");
}

}  // namespace trace::test
