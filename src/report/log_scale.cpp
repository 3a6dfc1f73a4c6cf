#include "report/log_scale.hpp"

#include <algorithm>
#include <cmath>

namespace trace {

LogScale::LogScale(const std::vector<double>& values, double begin, double end) : begin_(begin), end_(end) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  low_ = values.empty() ? 0 : std::log10(*least);
  high_ = values.empty() ? 0 : std::log10(*most);
  const double margin = 0.1 + 0.06 * (high_ - low_);
  low_ -= margin;
  high_ += margin;
}

double LogScale::operator()(double value) const {
  return begin_ + (std::log10(value) - low_) / (high_ - low_) * (end_ - begin_);
}

std::vector<double> LogScale::ticks() const {
  const std::vector<int> digits = high_ - low_ > 3 ? std::vector{1} : std::vector{1, 2, 5};
  std::vector<double> found;
  for (int power = int(std::floor(low_)); power <= int(std::floor(high_)); ++power) {
    for (const int digit : digits) {
      const double tick = power < 0 ? digit / std::pow(10.0, -power) : digit * std::pow(10.0, power);
      if (const double place = std::log10(tick); place >= low_ && place <= high_) found.push_back(tick);
    }
  }
  return found;
}

}  // namespace trace
