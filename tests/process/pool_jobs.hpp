// Short ways to run jobs in a pool from a test.
#pragma once

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "process/worker_pool.hpp"

namespace trace::test {

inline constexpr std::chrono::duration<double> long_enough{60};  // for what should take no time at all

// Everything the pool has to do, by id. Fails the test where that takes longer than `long_enough`.
inline std::map<JobId, FinishedJob> finish_all(WorkerPool& pool) {
  std::map<JobId, FinishedJob> all;
  const auto end = Clock::now() + long_enough;
  while (!pool.idle() && Clock::now() < end) {
    for (FinishedJob& job : pool.wait(std::chrono::milliseconds(1000))) {
      REQUIRE(all.count(job.id) == 0);
      all[job.id] = std::move(job);
    }
  }
  REQUIRE(pool.idle());
  return all;
}

// One job alone in a pool of its own.
inline FinishedJob run_job(const Work& work, std::string job = "", Limits limits = {}) {
  WorkerPool pool(1, work);
  pool.submit(1, std::move(job), limits);
  return finish_all(pool).at(1);
}

// The number of files this process has open.
std::size_t open_files();

// Whether the process is there and not a zombie.
bool alive(pid_t process);
// Waits until it is gone, for at most `long_enough`.
bool soon_gone(pid_t process);

// The plain action of the signal, which a sanitizer otherwise replaces by a report.
[[noreturn]] void crash(int signal);

// A number that this process and those it forks share.
class SharedNumber {
 public:
  SharedNumber();
  SharedNumber(const SharedNumber&) = delete;
  SharedNumber& operator=(const SharedNumber&) = delete;
  ~SharedNumber();

  std::atomic<int>& operator*() { return *number_; }
  void wait_for_change() const;  // from 0, for at most `long_enough`

 private:
  std::atomic<int>* number_;
};

// Takes memory, and writes to it, until something stops that, up to 4 GiB.
void exhaust_memory();

}  // namespace trace::test
