// Measurements as a block of aligned lines.
#pragma once

#include <string>

#include "comparison/measurements.hpp"

namespace trace {

// Four significant digits at most: "0.4966", "255", "inf".
std::string figure(double value);

// "red" of three or four channels, "gray" of one or two, "alpha" of the last of two or four; else "channel
// 5".
std::string channel_name(int channel, int channels);

// Pictures without a difference get one line, their size.
std::string figures_text(const Measurements& measured);

}  // namespace trace
