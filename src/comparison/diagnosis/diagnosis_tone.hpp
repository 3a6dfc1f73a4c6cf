// The same picture through one curve, the same for all channels: another gamma, another brightness.
//
// A reference level v stands for true values from v - 1/2 (a program that rounds) to v + 1 (one that
// truncates), at 255 for everything above. A curve f is obeyed by a pair of levels (v, t) where t is in the
// image of that interval, plus and minus one level. All pairs of the pictures are counted in one joint
// histogram (after the photometric registration of Mann 2000, "Comparametric equations", which fits g(f) the
// same way), so that trying a curve costs 256 lookups.
#pragma once

#include <optional>

#include "comparison/diagnosis/diagnosis_pair.hpp"

namespace trace {

// Gamma (test = reference ^ g), the sRGB curve, or a factor. Nothing where two of them fit alike.
std::optional<Finding> find_tone(const PicturePair& pair);

}  // namespace trace
