// Differences along edges only: antialiasing, or another place of the sample in the pixel.
#pragma once

#include <optional>

#include "comparison/diagnosis/diagnosis_pair.hpp"

namespace trace {

struct EdgeSigns {
  std::size_t pixels = 0;  // that differ by more than a few levels; the shares are of an even choice of these
  // Whose colour in the test picture is not among those around it in the reference, or, where that is less,
  // the other way round: of a smooth and a jagged picture, only the smooth one's colours are all in the
  // other.
  double outside = 0;
  double brighter = 0;  // whose sum of channels is higher in the test picture
  double thick = 0;     // whose 3x3 neighbours all differ so
  double parts = 0;     // of 8 x 8 parts of the picture, of those with edges, the share that differs anywhere
};

EdgeSigns edge_signs(const PicturePair& pair);

// A sample moved within its pixel, or the mean of several, lies between the colours around it in the
// reference. The finding needs that nearly every differing pixel does; that some become brighter and some
// darker; that they are not whole surfaces; and that most parts of the picture with edges have some, as a
// single object out of place has not. What is left over is the share of differing pixels that lie outside of
// their surroundings.
std::optional<Finding> find_edges(const PicturePair& pair);

}  // namespace trace
