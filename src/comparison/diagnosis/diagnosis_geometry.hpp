// The same picture in other places or with its channels in another order: shifts, flips, swapped channels.
//
// Each hypothesis predicts the test picture exactly: test(x, y) = reference(mapped place), so a true one
// leaves rounding alone. It is accepted where over its domain (for shifts, where both pictures have the
// pixel) at most 2 % of the pixels that differ, and 2 % of the squared error, are left. A share of 2 % lets
// through what a program does at borders and at single pixels that sit on an edge; a false shift of a picture
// with edges leaves tens of per cent.
#pragma once

#include <optional>

#include "comparison/diagnosis/diagnosis_pair.hpp"

namespace trace {

std::optional<Finding> find_channel_order(const PicturePair& pair);

// Left-right, upside down, or both.
std::optional<Finding> find_flip(const PicturePair& pair);

// Flips with a shift by one pixel along either axis, as a mirrored axis of the camera makes them where a
// pixel's sample is its corner. In symmetric pictures they explain what a plain shift does too: ask for the
// others first.
std::optional<Finding> find_mirrored_axis(const PicturePair& pair);

// By 1 to 4 pixels along either axis or both. The direction is that in which the content of the test picture
// moved.
std::optional<Finding> find_shift(const PicturePair& pair);

}  // namespace trace
