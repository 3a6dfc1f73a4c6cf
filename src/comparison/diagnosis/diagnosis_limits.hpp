// The ends of the range: a picture of one colour, and bytes that wrap around instead of being limited.
#pragma once

#include <optional>

#include "comparison/diagnosis/diagnosis_pair.hpp"

namespace trace {

// The test picture is of one colour, and the reference is not.
std::optional<Finding> find_blank(const PicturePair& pair);

// The pictures are equal but where the reference is at 255. There the test picture begins again at zero: next
// to a sample of the reference just below the limit it is dark.
std::optional<Finding> find_wrapped(const PicturePair& pair);

}  // namespace trace
