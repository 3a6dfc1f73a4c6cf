// Times of one thing measured again and again.
#pragma once

#include <vector>

namespace trace {

struct MedianTime {
  double median = 0, low = 0,
         high = 0;  // milliseconds; the interval holds the true median in 19 of 20 cases, from 6 runs on
  int runs = 0;
};

// The median, and order statistics around it: of n times that come from one distribution, the number below
// its median is binomial, so ranks 0.98 sqrt(n) from the middle hold it with 95 % (Conover, "Practical
// Nonparametric Statistics", 3.2). With fewer than 6 the interval is all of them, which hold it with 1 - 2^(1
// - n).
MedianTime median_time(std::vector<double> milliseconds);

}  // namespace trace
