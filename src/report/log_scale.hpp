// A logarithmic axis of a picture.
#pragma once

#include <vector>

namespace trace {

class LogScale {
 public:
  // Around these values (positive; none: around 1), with a margin; they lie from `begin` to `end` in the
  // picture.
  LogScale(const std::vector<double>& values, double begin, double end);

  double operator()(double value) const;  // where it is in the picture

  // Numbers to be written beside it, all within: powers of ten, with 2 and 5 times them where the axis is
  // short.
  std::vector<double> ticks() const;

 private:
  double low_, high_;  // logarithms to base 10
  double begin_, end_;
};

}  // namespace trace
