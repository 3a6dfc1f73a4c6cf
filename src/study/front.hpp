// Which settings are worth their time.
#pragma once

#include <span>
#include <vector>

namespace trace {

struct Cost {
  double time = 0, error = 0;
};

// Whether no other is at least as good in both and better in one (the Pareto front). Equal ones are both on
// it.
std::vector<bool> pareto_front(std::span<const Cost> costs);

// The place of the fastest with an error of at most `error`; -1 for none.
int fastest_within(std::span<const Cost> costs, double error);

}  // namespace trace
