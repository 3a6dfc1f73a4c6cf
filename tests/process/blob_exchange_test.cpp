#include "process/blob_exchange.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "process/worker_pool.hpp"
#include "tests/process/pool_jobs.hpp"
#include "tests/support/temporary_folder.hpp"

namespace trace::test {
namespace {

std::vector<std::uint8_t> numbers(std::size_t size) {
  std::vector<std::uint8_t> all(size);
  for (std::size_t i = 0; i < size; ++i) all[i] = std::uint8_t(i * 7);
  return all;
}

bool right(const Blob& blob, std::size_t size) {
  const auto expected = numbers(size);
  return std::equal(blob.bytes.begin(), blob.bytes.end(), expected.begin(), expected.end());
}

void pause_for(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

}  // namespace

TEST_CASE("outside a worker a blob is just made") {
  BlobExchange nobody;
  CHECK(right(nobody.get("key", [] { return numbers(1000); }), 1000));
}

TEST_CASE("a blob is made once for all workers, and those that ask meanwhile wait") {
  WorkerPool pool(4, [](std::string_view, BlobExchange& blobs) {
    bool made = false;
    const Blob blob = blobs.get("texture", [&] {
      made = true;
      pause_for(50);
      return numbers(1'000'000);
    });
    return std::string(right(blob, 1'000'000) ? "right" : "wrong") + (made ? ", made" : "");
  });
  for (JobId id = 0; id < 40; ++id) pool.submit(id, "");
  int made = 0;
  for (const auto& [id, job] : finish_all(pool)) {
    CHECK(job.answer.substr(0, 5) == "right");
    made += job.answer == "right, made";
  }
  CHECK(made == 1);
}

TEST_CASE("a blob outlives its maker, the exchange and the pool's interest in it") {
  WorkerPool pool(WorkerPoolOptions{1, 1}, [](std::string_view, BlobExchange& blobs) {
    Blob blob = blobs.get("a", [] { return numbers(5000); });
    for (std::size_t i = 0; i < kept_blobs + 10; ++i)
      blobs.get("other " + std::to_string(i), [] { return numbers(1); });
    return std::to_string(right(blob, 5000));
  });
  for (JobId id = 0; id < 3; ++id) pool.submit(id, "");
  for (const auto& [id, job] : finish_all(pool)) CHECK(job.answer == "1");
}

TEST_CASE("different keys are different blobs, and a blob may be empty") {
  const FinishedJob job = run_job([](std::string_view, BlobExchange& blobs) {
    const Blob small = blobs.get("small", [] { return numbers(10); });
    const Blob empty = blobs.get("empty", [] { return numbers(0); });
    return std::to_string(small.bytes.size()) + " " + std::to_string(empty.bytes.size());
  });
  CHECK(job.answer == "10 0");
}

TEST_CASE("a blob cannot be written to") {
  const FinishedJob job = run_job([](std::string_view, BlobExchange& blobs) {
    const Blob blob = blobs.get("key", [] { return numbers(10); });
    auto* start = const_cast<std::uint8_t*>(blob.bytes.data());
    std::signal(SIGSEGV, SIG_DFL);
    *static_cast<volatile std::uint8_t*>(start) = 1;
    return std::string("written");
  });
  CHECK(job.outcome == Outcome{Outcome::Kind::signalled, SIGSEGV});
}

TEST_CASE("where the maker of a blob crashes, the next one who asks makes it") {
  SharedNumber making;
  WorkerPool pool(3, [&](std::string_view job, BlobExchange& blobs) {
    if (job != "first") making.wait_for_change();
    bool made = false;
    const Blob blob = blobs.get("texture", [&] {
      made = true;
      if (job == "first") {
        *making = 1;
        pause_for(100);
        crash(SIGSEGV);
      }
      return numbers(1000);
    });
    return std::to_string(right(blob, 1000)) + (made ? " made" : "");
  });
  pool.submit(0, "first");
  for (JobId id = 1; id < 10; ++id) pool.submit(id, "");
  auto all = finish_all(pool);
  CHECK(all.at(0).outcome == Outcome{Outcome::Kind::signalled, SIGSEGV});
  all.erase(0);
  int made = 0;
  for (const auto& [id, job] : all) {
    CHECK(job.answer.substr(0, 1) == "1");
    made += job.answer == "1 made";
  }
  CHECK(made == 1);
}

TEST_CASE("what the maker of a blob throws is its own error alone") {
  SharedNumber making;
  WorkerPool pool(2, [&](std::string_view job, BlobExchange& blobs) {
    if (job != "bad") making.wait_for_change();
    const Blob blob = blobs.get("texture", [&] {
      *making = 1;
      if (job == "bad") throw std::runtime_error("not a picture");
      return numbers(1000);
    });
    return std::to_string(right(blob, 1000));
  });
  pool.submit(0, "bad");
  for (JobId id = 1; id < 6; ++id) pool.submit(id, "");
  auto all = finish_all(pool);
  CHECK(all.at(0).errors == "not a picture");
  for (JobId id = 1; id < 6; ++id) CHECK(all.at(id).answer == "1");
}

TEST_CASE("the time a job waits for another one's blob is not taken from its limit") {
  SharedNumber making;
  WorkerPool pool(2, [&](std::string_view job, BlobExchange& blobs) {
    if (job == "waits") making.wait_for_change();
    blobs.get("texture", [&] {
      *making = 1;
      if (job == "hangs") pause();
      return numbers(10);
    });
    return std::string("well");
  });
  pool.submit(1, "hangs", {std::chrono::duration<double>(1.5), 0});
  pool.submit(2, "waits", {std::chrono::duration<double>(1), 0});
  const auto all = finish_all(pool);
  CHECK(all.at(1).outcome.kind == Outcome::Kind::timed_out);
  CHECK(all.at(2).answer == "well");
}

TEST_CASE("two jobs that need each other's blob while they make one do not wait for ever") {
  SharedNumber making;  // to be 2 before either asks for the other's
  WorkerPool pool(2, [&](std::string_view job, BlobExchange& blobs) {
    const std::string other = job == "a" ? "b" : "a";
    const Blob blob = blobs.get(std::string(job), [&] {
      for (++*making; *making < 2;) pause_for(1);
      const Blob inner = blobs.get(other, [] { return numbers(10); });
      return numbers(inner.bytes.size() + 1);
    });
    return std::to_string(blob.bytes.size());
  });
  pool.submit(1, "a");
  pool.submit(2, "b");
  const auto all = finish_all(pool);
  CHECK(all.at(1).answered());
  CHECK(all.at(2).answered());
}

}  // namespace trace::test
