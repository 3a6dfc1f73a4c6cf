// What the sign and the colour of a difference say of it, over all pixels that differ.
#pragma once

#include "comparison/diagnosis/diagnosis_pair.hpp"

namespace trace {

struct DifferenceSigns {
  // Shares of the differing pixels with a channel that is brighter, or darker, by more than a level.
  double brighter = 0, darker = 0;
  // Of the pixels that are lit well enough in both pictures to have a colour: the share whose two colours
  // have the same direction, and the number of these pixels.
  double same_color = 0;
  std::size_t colored = 0;
  // Share of the differing pixels whose difference has the direction of the darker of their two colours.
  double difference_of_same_color = 0;
  // Shares of the differing pixels that are all but black in the reference, and in the test picture.
  double black_in_reference = 0, black_in_test = 0;
  // Share of the differing pixels whose difference has the direction of the mean difference.
  double difference_of_one_color = 0;
};

// Of the pixels that are lit in either picture, the share that does not differ.
double lit_and_equal(const PicturePair& pair);

DifferenceSigns difference_signs(const PicturePair& pair);

}  // namespace trace
