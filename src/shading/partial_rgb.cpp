#include "shading/partial_rgb.hpp"

namespace trace {
namespace {

bool is_nothing_times_infinity(double a, double b) {
  return (a == 0 && std::isinf(b)) || (std::isinf(a) && b == 0);
}

bool is_infinity_less_infinity(double a, double b) {
  return std::isinf(a) && std::isinf(b) && std::signbit(a) != std::signbit(b);
}

}  // namespace

PartialRgb product_by_rule(const PartialRgb& a, const PartialRgb& b) {
  PartialRgb result(Rgb(0), a.undefined | b.undefined);
  for (int channel = 0; channel < 3; ++channel) {
    const double x = a.value[channel], y = b.value[channel];
    if (is_nothing_times_infinity(x, y)) result.undefined |= Channels(channel);
    if (!result.undefined.has(channel)) result.value[channel] = x * y;
  }
  return result;
}

PartialRgb sum_by_rule(const PartialRgb& a, const PartialRgb& b) {
  PartialRgb result(Rgb(0), a.undefined | b.undefined);
  for (int channel = 0; channel < 3; ++channel) {
    const double x = a.value[channel], y = b.value[channel];
    if (is_infinity_less_infinity(x, y)) result.undefined |= Channels(channel);
    if (!result.undefined.has(channel)) result.value[channel] = x + y;
  }
  return result;
}

}  // namespace trace
