// How much the corners of a pixel differ, and how many samples that is worth.
//
// A pixel that an edge of contrast C crosses has, with n x n samples, an error that grows as C and falls as
// n^-3/2: of n^2 cells the edge crosses some 2 n, each wrong by up to half of C / n^2 either way, so that the
// sum is some sqrt(2 n) C / (2 n^2). So n = (C / threshold)^(2/3) makes the error of all such pixels alike.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace trace {

// Contrasts in levels are kept by half octaves: 0 for less than 1/16, then [1/16, 1.5/16), [1.5/16, 2/16) ...
inline constexpr int contrast_bins = 25;

// A float's exponent and the first bit of its fraction say which. Negative numbers and NaN do not occur.
inline int contrast_bin(float levels) {
  constexpr int below = (127 - 4) * 2 - 1;  // of the bin before the first
  return std::clamp(static_cast<int>(std::bit_cast<std::uint32_t>(levels) >> 22) - below, 0,
                    contrast_bins - 1);
}

// The least contrast in a bin.
inline double contrast_of_bin(int bin) {
  if (bin == 0) return 0;
  const double octave = static_cast<double>(1u << ((bin - 1) / 2)) / 16;
  return bin % 2 == 1 ? octave : 1.5 * octave;
}

// For each bin the n of n x n samples; 0: the mean of the corners is enough.
using GridByContrast = std::array<std::uint8_t, contrast_bins>;

inline constexpr std::array<std::uint8_t, 8> grid_ladder{0, 2, 3, 4, 6, 8, 12, 16};

// The rule above for the middle of each bin, with the nearest step of the ladder, at most `most`. The mean of
// the corners counts as n = 1.
GridByContrast grids_for_threshold(double threshold, int most);

}  // namespace trace
