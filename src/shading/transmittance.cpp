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

}  // namespace trace
