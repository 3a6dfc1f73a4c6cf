#include "study/timing.hpp"

#include <algorithm>
#include <cmath>

namespace trace {

MedianTime median_time(std::vector<double> milliseconds) {
  if (milliseconds.empty()) return {};
  std::sort(milliseconds.begin(), milliseconds.end());
  const std::size_t n = milliseconds.size();
  const double reach = 0.98 * std::sqrt(static_cast<double>(n));
  const auto low = static_cast<std::size_t>(std::max(0.0, std::floor(static_cast<double>(n) / 2 - reach)));
  const double median =
      n % 2 == 1 ? milliseconds[n / 2] : (milliseconds[n / 2 - 1] + milliseconds[n / 2]) / 2;
  return {median, milliseconds[low], milliseconds[n - 1 - low], static_cast<int>(n)};
}

}  // namespace trace
