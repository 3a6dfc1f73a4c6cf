// What a way through a transmissive material leaves of light.
#pragma once

#include "shading/partial_rgb.hpp"

namespace trace {

// The way that a ray which hits nothing has gone, for attenuation.
inline constexpr double length_of_miss = -1;

// kt to the power of the length of the way, channel by channel (Beer's law; docs/language.md section 6).
// A miss divides by kt, so that a channel whose kt is 0 is infinite: times a background that is black in that
// channel it becomes undefined. A negative kt has powers of whole lengths only; of others the channel is
// undefined.
PartialRgb transmittance(const Rgb& kt, double length);

// The same with Beer's coefficients: what is left is multiplied by exp(-absorb * length). They do nothing to
// what is seen of nothing.
PartialRgb transmittance(const Rgb& kt, const Rgb& absorb, double length);

}  // namespace trace
