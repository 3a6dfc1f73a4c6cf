// Where a pair of pictures differs: connected regions, and what happened at their outlines and inside.
//
// What a region is can be read from its outline. Across it the pictures agree on the outer side, so that each
// pair of an inner and an outer pixel tells whether an edge that the reference has there is in the test
// picture too:
//   vanished  only in the reference (the outline of a missing object or of a missing shadow)
//   appeared  only in the test picture (of an object where none should be)
//   kept      in both (of an object that is there but looks different)
//   soft      in neither: the difference fades out (highlights, light that falls off)
#pragma once

#include <vector>

#include "comparison/diagnosis/diagnosis_pair.hpp"

namespace trace {

struct EdgeCounts {
  std::size_t vanished = 0, appeared = 0, kept = 0, soft = 0;

  std::size_t total() const { return vanished + appeared + kept + soft; }
  double share(std::size_t part) const {
    return total() == 0 ? 0 : static_cast<double>(part) / static_cast<double>(total());
  }
  EdgeCounts& operator+=(const EdgeCounts& other) {
    vanished += other.vanished;
    appeared += other.appeared;
    kept += other.kept;
    soft += other.soft;
    return *this;
  }
};

struct DifferingRegion {
  Region box;
  double energy = 0;   // squared difference, summed
  EdgeCounts outline;  // pairs across it
  EdgeCounts inside;   // pairs of neighbours within it; `soft` are not counted
};

// By falling energy. Connected are pixels in the same or neighbouring cells of 4 x 4 pixels, so that an
// object, its shadow and what a few equal pixels cut off it are one. Regions of fewer than 9 pixels are left
// out.
std::vector<DifferingRegion> differing_regions(const PicturePair& pair);

}  // namespace trace
