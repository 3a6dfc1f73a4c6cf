#include "study/front.hpp"

#include <algorithm>

namespace trace {

std::vector<bool> pareto_front(std::span<const Cost> costs) {
  std::vector<bool> result;
  for (const Cost& own : costs) {
    result.push_back(std::none_of(costs.begin(), costs.end(), [&](const Cost& other) {
      return other.time <= own.time && other.error <= own.error &&
             (other.time < own.time || other.error < own.error);
    }));
  }
  return result;
}

int fastest_within(std::span<const Cost> costs, double error) {
  int best = -1;
  for (std::size_t k = 0; k < costs.size(); ++k) {
    if (costs[k].error > error) continue;
    if (best < 0 || costs[k].time < costs[static_cast<std::size_t>(best)].time) best = static_cast<int>(k);
  }
  return best;
}

}  // namespace trace
