#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

#include "process/worker_pool.hpp"
#include "tests/process/pool_jobs.hpp"
#include "tests/support/temporary_folder.hpp"

namespace trace::test {
namespace {

std::string reversed(std::string_view job, BlobExchange&) {
  return {job.rbegin(), job.rend()};
}

}  // namespace

TEST_CASE("a thousand small jobs over two workers are each answered once") {
  WorkerPool pool(2, reversed);
  for (JobId id = 0; id < 1000; ++id) pool.submit(id, "job " + std::to_string(id));
  CHECK(pool.queued() == 1000);
  const auto all = finish_all(pool);
  REQUIRE(all.size() == 1000);
  for (const auto& [id, job] : all) {
    const std::string text = "job " + std::to_string(id);
    REQUIRE(job.answered());
    REQUIRE(job.answer == std::string(text.rbegin(), text.rend()));
  }
}

TEST_CASE("jobs are started in the order they were submitted") {
  WorkerPool pool(1,
                  [count = 0](std::string_view, BlobExchange&) mutable { return std::to_string(count++); });
  for (JobId id = 0; id < 5; ++id) pool.submit(id, "");
  const auto all = finish_all(pool);
  for (const auto& [id, job] : all) CHECK(job.answer == std::to_string(id));
}

TEST_CASE("jobs and answers may be of fifty megabytes or empty, and hold any byte") {
  std::string large(std::size_t{50} << 20, '\0');
  for (std::size_t i = 0; i < large.size(); i += 4099) large[i] = char(i % 251);
  WorkerPool pool(2, [](std::string_view job, BlobExchange&) { return std::string(job); });
  pool.submit(1, large);
  pool.submit(2, "");
  const auto all = finish_all(pool);
  CHECK(all.at(1).answer == large);
  CHECK(all.at(2).answered());
  CHECK(all.at(2).answer.empty());
}

TEST_CASE("a job that crashes is reported with its signal, and the others are done") {
  WorkerPool pool(2, [](std::string_view job, BlobExchange&) -> std::string {
    if (job == "segv") crash(SIGSEGV);
    if (job == "abort") crash(SIGABRT);
    if (job == "exit") std::exit(7);
    return "well";
  });
  pool.submit(1, "segv");
  pool.submit(2, "abort");
  pool.submit(3, "exit");
  for (JobId id = 4; id < 20; ++id) pool.submit(id, "");
  const auto all = finish_all(pool);
  CHECK(all.at(1).outcome == Outcome{Outcome::Kind::signalled, SIGSEGV});
  CHECK(text(all.at(1).outcome) == "crashed (segmentation fault)");
  CHECK(all.at(2).outcome == Outcome{Outcome::Kind::signalled, SIGABRT});
  CHECK(all.at(3).outcome == Outcome{Outcome::Kind::exited, 7});
  for (JobId id = 4; id < 20; ++id) CHECK(all.at(id).answer == "well");
}

TEST_CASE("an exception ends its worker and is reported with its text") {
  WorkerPool pool(1, [](std::string_view job, BlobExchange&) -> std::string {
    if (job == "throw") throw std::runtime_error("no such thing");
    return "well";
  });
  pool.submit(1, "throw");
  pool.submit(2, "");
  const auto all = finish_all(pool);
  CHECK(all.at(1).outcome == Outcome{Outcome::Kind::exited, 1});
  CHECK(all.at(1).errors == "no such thing");
  CHECK(all.at(2).answer == "well");
}

TEST_CASE("what a job writes is told with that job, its middle left out where it is long") {
  WorkerPool pool(1, [](std::string_view job, BlobExchange&) -> std::string {
    if (job == "much") {
      std::cerr << "begin";
      for (int i = 0; i < 100'000; ++i) std::fputs("many words on the error stream\n", stderr);
      std::printf("end");
    } else {
      std::cerr << job;
    }
    return "";
  });
  pool.submit(1, "much");
  pool.submit(2, "little");
  const auto all = finish_all(pool);
  const std::string& errors = all.at(1).errors;
  CHECK(errors.size() < 70'000);
  CHECK(errors.substr(0, 5) == "begin");
  CHECK(errors.substr(errors.size() - 3) == "end");
  CHECK(errors.find("bytes left out") != std::string::npos);
  CHECK(all.at(2).errors == "little");
}

TEST_CASE("a worker killed from outside costs its own job only") {
  WorkerPool pool(1, [](std::string_view job, BlobExchange&) -> std::string {
    if (job == "victim") crash(SIGKILL);
    return std::to_string(getpid());
  });
  pool.submit(1, "");
  const pid_t idle_worker = pid_t(std::stol(finish_all(pool).at(1).answer));
  kill(idle_worker, SIGKILL);
  REQUIRE(soon_gone(idle_worker));
  pool.submit(2, "");
  pool.submit(3, "victim");
  pool.submit(4, "");
  const auto all = finish_all(pool);
  CHECK(all.at(2).answered());
  CHECK(all.at(3).outcome == Outcome{Outcome::Kind::signalled, SIGKILL});
  CHECK(all.at(4).answered());
}

TEST_CASE("workers stay for further jobs unless they are told to be replaced") {
  const Work name_yourself = [](std::string_view, BlobExchange&) { return std::to_string(getpid()); };
  const auto two_jobs = [&](int jobs_per_worker) {
    WorkerPool pool(WorkerPoolOptions{1, jobs_per_worker}, name_yourself);
    pool.submit(1, "");
    pool.submit(2, "");
    const auto all = finish_all(pool);
    return std::pair(all.at(1).answer, all.at(2).answer);
  };
  const auto staying = two_jobs(0), replaced = two_jobs(1);
  CHECK(staying.first == staying.second);
  CHECK(replaced.first != replaced.second);
}

TEST_CASE("a stopped pool has nothing to do, and can be used again") {
  WorkerPool pool(2, [](std::string_view job, BlobExchange&) -> std::string {
    if (job == "hang") pause();
    return "well";
  });
  for (JobId id = 0; id < 5; ++id) pool.submit(id, "hang");
  pool.wait(std::chrono::milliseconds(0));
  CHECK(pool.running().size() == 2);
  CHECK(pool.queued() == 3);
  pool.stop();
  CHECK(pool.idle());
  CHECK(pool.wait(std::chrono::hours(1)).empty());
  pool.submit(9, "");
  CHECK(finish_all(pool).at(9).answer == "well");
}

TEST_CASE("a pool leaves neither processes nor open files behind") {
  const std::size_t before = open_files();
  std::string worker;
  {
    WorkerPool pool(2, [](std::string_view job, BlobExchange& blobs) -> std::string {
      if (job == "crash") crash(SIGSEGV);
      blobs.get("blob", [] { return std::vector<std::uint8_t>(1000); });
      return std::to_string(getpid());
    });
    for (JobId id = 0; id < 20; ++id) pool.submit(id, id % 5 == 4 ? "crash" : "");
    worker = finish_all(pool).at(0).answer;
    CHECK(open_files() > before);
  }
  CHECK(open_files() == before);
  CHECK(kill(pid_t(std::stol(worker)), 0) == -1);  // not even a zombie
}

TEST_CASE("a worker runs nothing of what the supervisor left for its own end") {
  static std::atomic<int>* ended = nullptr;
  SharedNumber number;
  ended = &*number;
  std::atexit([] {
    if (ended != nullptr) ++*ended;
  });
  const TemporaryFolder folder;
  const auto file = folder.path() / "text";
  std::FILE* stream = std::fopen(file.c_str(), "w");
  std::fputs("once", stream);
  {
    WorkerPool pool(1, [](std::string_view job, BlobExchange&) -> std::string {
      if (job == "exit") std::exit(0);
      if (job == "throw") throw 1;
      return "";
    });
    pool.submit(1, "exit");
    pool.submit(2, "throw");
    pool.submit(3, "");
    const auto all = finish_all(pool);
    CHECK(all.at(1).outcome == Outcome{Outcome::Kind::exited, 0});
    CHECK_FALSE(all.at(1).answered());
    CHECK(all.at(2).errors == "exception of an unknown type");
    CHECK(all.at(3).answered());
  }
  std::fclose(stream);
  CHECK(read_text(file) == "once");
  CHECK(*number == 0);
  ended = nullptr;
}

TEST_CASE("what a job took is measured") {
  const FinishedJob job = run_job([](std::string_view, BlobExchange&) -> std::string {
    std::vector<char> memory(std::size_t{64} << 20, 'x');
    double sum = 0;
    const auto end = Clock::now() + std::chrono::milliseconds(30);
    while (Clock::now() < end) sum += memory[std::size_t(sum) % memory.size()];
    return std::to_string(sum);
  });
  CHECK(job.seconds >= 0.03);
  CHECK(job.seconds < long_enough.count());
  CHECK(job.cpu_seconds > 0);
  CHECK(job.peak_memory_bytes > std::uint64_t{64} << 20);
}

}  // namespace trace::test
