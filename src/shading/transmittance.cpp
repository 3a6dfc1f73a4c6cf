#include "shading/transmittance.hpp"

namespace trace {

PartialRgb transmittance(const Rgb& kt, double length) {
  PartialRgb power(glm::pow(kt, Rgb(length)));
  if (power.finite()) return power;
  const bool whole = length == std::trunc(length);
  for (int channel = 0; channel < 3; ++channel) {
    if (kt[channel] < 0 && !whole) {
      power.value[channel] = 0;
      power.undefined |= Channels(channel);
    }
  }
  return power;
}

PartialRgb transmittance(const Rgb& kt, const Rgb& absorb, double length) {
  const PartialRgb left = transmittance(kt, length);
  if (is_zero(absorb) || length == length_of_miss) return left;
  return left * PartialRgb(glm::exp(-absorb * length));
}

}  // namespace trace
