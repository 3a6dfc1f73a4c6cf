// Medians of times and their intervals.
#include "study/timing.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

namespace trace::test {
namespace {

// Of an even chance each, the share of n that come out at most k.
double at_most(int k, int n) {
  double sum = 0, own = std::pow(0.5, n);
  for (int i = 0; i <= k; ++i) {
    sum += own;
    own = own * (n - i) / (i + 1);
  }
  return sum;
}

// 0, 1, ... n - 1 milliseconds, so that a time is its rank, in another order.
MedianTime of_ranks(int n) {
  std::vector<double> times;
  for (int k = 0; k < n; ++k) times.push_back(k);
  std::rotate(times.begin(), times.begin() + n / 3, times.end());
  return median_time(times);
}

}  // namespace

TEST_CASE("the median is the middle one, or the mean of the two in the middle, in any order") {
  CHECK(median_time({5}).median == 5);
  CHECK(median_time({9, 1}).median == 5);
  CHECK(median_time({9, 1, 2}).median == 2);
  CHECK(median_time({100, 1, 4, 2}).median == 3);
  CHECK(median_time({3, 3, 3}).median == 3);
}

TEST_CASE("no times have no median and no runs") {
  const MedianTime none = median_time({});
  CHECK(none.runs == 0);
  CHECK(none.median == 0);
  CHECK(none.high == 0);
}

TEST_CASE("with fewer than six runs the interval is all of them") {
  for (int n = 1; n < 6; ++n) {
    const MedianTime time = of_ranks(n);
    CHECK(time.runs == n);
    CHECK(time.low == 0);
    CHECK(time.high == n - 1);
  }
}

TEST_CASE("from six runs on the interval holds the true median in about 19 of 20 cases") {
  for (int n = 6; n <= 200; ++n) {
    const MedianTime time = of_ranks(n);
    INFO(n);
    CHECK(time.low + time.high == n - 1);
    CHECK(time.low <= time.median);
    const double held = 1 - 2 * at_most(static_cast<int>(time.low), n);
    CHECK(held > 0.92);
    CHECK(held < 0.99);
  }
}

TEST_CASE("one run that took very long does not move the median, nor the interval of many runs") {
  std::vector<double> times(20, 7);
  times[4] = 1e6;
  const MedianTime time = median_time(times);
  CHECK(time.median == 7);
  CHECK(time.low == 7);
  CHECK(time.high == 7);
}

}  // namespace trace::test
