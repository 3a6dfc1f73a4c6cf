// What a second thread adds on this machine at best: sums and products in registers, the same for each
// thread, which share no memory. Two processors that are threads of one core, or not wholly ours, show here.
#include <array>
#include <numeric>

#include "parallel/parallel.hpp"
#include "tools/benchmark/kernels/repeated.hpp"
#include "tools/benchmark/kernels/stages.hpp"

namespace trace::bench {
namespace {

// Some 20 ms of work that keeps the units of arithmetic busy; the sum is there for its sake.
double calculate() {
  constexpr int steps = 6'000'000;
  std::array<double, 16> values;
  std::iota(values.begin(), values.end(), 1.0);
  for (int step = 0; step < steps; ++step) {
    for (double& value : values) value = value * 0.75 + 0.5;
  }
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double calculate_on(int threads) {
  std::vector<double> sums(static_cast<std::size_t>(threads));
  on_threads(threads, [&](int thread) { sums[static_cast<std::size_t>(thread)] = calculate(); });
  return sums.front();
}

}  // namespace

void measure_threads(int repetitions) {
  std::vector<double> speedups;
  for (int i = 0; i < repetitions; ++i) {
    const double one = timed([] { return calculate_on(1); }), two = timed([] { return calculate_on(2); });
    speedups.push_back(2 * one / two);
  }
  std::sort(speedups.begin(), speedups.end());
  fmt::print("threads speedup={:.4f} least={:.4f} most={:.4f}\n", speedups[speedups.size() / 2],
             speedups.front(), speedups.back());
}

}  // namespace trace::bench
