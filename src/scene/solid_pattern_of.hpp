// From what the file says of a pattern in space to the pattern.
#pragma once

#include "parser/description.hpp"
#include "scene/solid_pattern.hpp"

namespace trace {

// What is not given: of marble color (1, 1, 1), lightness 0.5, contrast 0.8, frequency 20, scale 1, depth 4;
// of noise scale 4, depth 7. A depth is cut to a whole number from 0 to SolidPattern::most_depth.
SolidPattern pattern_of(const parser::SolidTexture& said);

}  // namespace trace
