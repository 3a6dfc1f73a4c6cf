#include "parallel/parallel.hpp"

#include <catch2/catch.hpp>
#include <algorithm>
#include <atomic>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace trace;

TEST_CASE("parallel_for gives out every index once, to threads below the number asked for") {
  for (const int threads : {1, 2, 7}) {
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{5}, std::size_t{1000}}) {
      std::vector<std::atomic<int>> calls(count);
      std::atomic<int> strangers{0};
      parallel_for(threads, count, [&](std::size_t i, int thread) {
        ++calls[i];
        if (thread < 0 || thread >= threads) ++strangers;
      });
      CHECK(std::all_of(calls.begin(), calls.end(), [](const auto& n) { return n == 1; }));
      CHECK(strangers == 0);
    }
  }
}

TEST_CASE("on_threads runs its calls side by side, 0 on the caller's thread") {
  // Each call waits for all others: it ends only if they are side by side.
  std::atomic<int> arrived{0};
  std::vector<std::thread::id> ids(3);
  on_threads(3, [&](int thread) {
    ids[static_cast<std::size_t>(thread)] = std::this_thread::get_id();
    ++arrived;
    while (arrived < 3) std::this_thread::yield();
  });
  CHECK(ids[0] == std::this_thread::get_id());
  CHECK(std::set<std::thread::id>(ids.begin(), ids.end()).size() == 3);
}

TEST_CASE("parallel_for throws what a body threw, once all threads have ended") {
  std::atomic<int> inside{0};
  const auto body = [&](std::size_t i, int) {
    ++inside;
    if (i == 10) {
      --inside;
      throw std::runtime_error("ten");
    }
    --inside;
  };
  CHECK_THROWS_WITH(parallel_for(3, 1000, body), "ten");
  CHECK(inside == 0);
}

namespace {

int sum(ThreadBudget& threads, int first, int last, std::atomic<int>& working, std::atomic<int>& most) {
  if (last - first == 1) {
    const int now = ++working;
    for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) continue;
    std::this_thread::yield();
    --working;
    return first;
  }
  const int middle = (first + last) / 2;
  int left = 0, right = 0;
  threads.both([&] { left = sum(threads, first, middle, working, most); },
               [&] { right = sum(threads, middle, last, working, most); });
  return left + right;
}

}  // namespace

TEST_CASE("Work that divides itself is done whole, by no more threads than its budget") {
  for (const int threads : {1, 2, 3, 8}) {
    ThreadBudget budget(threads);
    for (int again = 0; again < 20; ++again) {  // the budget is whole again afterwards
      std::atomic<int> working{0}, most{0};
      CHECK(sum(budget, 0, 256, working, most) == 255 * 256 / 2);
      CHECK(most <= threads);
    }
  }
}

TEST_CASE("both() ends both parts before it throws what either threw") {
  for (const int threads : {1, 2}) {
    ThreadBudget budget(threads);
    bool other = false;
    CHECK_THROWS_WITH(budget.both([&] { other = true; }, [] { throw std::runtime_error("b"); }), "b");
    CHECK(other);
    CHECK_THROWS_WITH(budget.both([] { throw std::runtime_error("a"); }, [] {}), "a");
    int done = 0;
    budget.both([&] { ++done; }, [] {});
    CHECK(done == 1);
  }
}
