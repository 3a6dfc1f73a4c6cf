#include "comparison/perceptual/flip_filters.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trace {
namespace {

using Weights = std::vector<double>;
constexpr double pi = std::numbers::pi;

// From 0.7 m on a screen that is 0.7 m and 3840 pixels wide.
constexpr double pixels_per_degree = 0.7 * (3840 / 0.7) * (pi / 180);

// f(-radius) to f(radius).
template <typename Function>
Weights sampled(int radius, Function f) {
  Weights weights;
  for (int x = -radius; x <= radius; ++x) weights.push_back(f(static_cast<double>(x)));
  return weights;
}

double sum(const Weights& weights) {
  double total = 0;
  for (double weight : weights) total += weight;
  return total;
}

FlipFilters::Taps scaled(const Weights& weights, double factor) {
  FlipFilters::Taps taps;
  for (double weight : weights) taps.push_back(static_cast<float>(weight * factor));
  return taps;
}

// exp(-pi^2 x^2 / b), x in degrees: a row of the two-dimensional filter.
Weights contrast(double b, int radius = color_radius) {
  return sampled(radius, [b](double pixels) {
    const double x = pixels / pixels_per_degree;
    return std::exp(-pi * pi * x * x / b);
  });
}

// Without the tails that are below a millionth of the middle.
Weights trimmed(const Weights& weights) {
  const double middle = weights[weights.size() / 2];
  std::size_t cut = 0;
  while (weights[cut] < 1e-6 * middle) ++cut;
  return {weights.begin() + static_cast<std::ptrdiff_t>(cut),
          weights.end() - static_cast<std::ptrdiff_t>(cut)};
}

// Negative weights to a sum of -1, positive ones to a sum of 1.
FlipFilters::Taps balanced(const Weights& weights) {
  double negative = 0, positive = 0;
  for (double weight : weights) (weight < 0 ? negative : positive) += std::abs(weight);
  FlipFilters::Taps taps;
  for (double weight : weights)
    taps.push_back(static_cast<float>(weight / (weight < 0 ? negative : positive)));
  return taps;
}

}  // namespace

FlipFilters flip_filters() {
  FlipFilters filters;
  const Weights light = trimmed(contrast(0.0047)), red_green = trimmed(contrast(0.0053));
  filters.light = scaled(light, 1 / sum(light));
  filters.red_green = scaled(red_green, 1 / sum(red_green));

  const double b1 = 0.04, b2 = 0.025;
  const double a1 = 34.1 * std::sqrt(pi / b1), a2 = 13.5 * std::sqrt(pi / b2);
  const Weights first = contrast(b1), second = contrast(b2);
  const double total = a1 * sum(first) * sum(first) + a2 * sum(second) * sum(second);
  filters.blue_yellow_1 = scaled(first, std::sqrt(a1 / total));
  filters.blue_yellow_2 = scaled(second, std::sqrt(a2 / total));

  const double deviation = 0.5 * 0.082 * pixels_per_degree;
  const auto gaussian = [=](double x) { return std::exp(-x * x / (2 * deviation * deviation)); };
  const Weights smooth = sampled(feature_radius, gaussian);
  filters.smooth = scaled(smooth, 1 / sum(smooth));
  filters.edge = balanced(sampled(feature_radius, [&](double x) { return -x * gaussian(x); }));
  filters.point = balanced(
      sampled(feature_radius, [&](double x) { return (x * x / (deviation * deviation) - 1) * gaussian(x); }));
  return filters;
}

}  // namespace trace
