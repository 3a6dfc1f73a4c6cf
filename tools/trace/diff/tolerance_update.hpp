// `trace diff --update`: the present differences become the tolerances.
#pragma once

#include <string>
#include <vector>

#include "comparison/judge.hpp"

namespace trace {

// The tolerance with every limit that the measurements exceed moved to just outside them (two significant
// digits; SSIM four decimals); other limits stay.
Tolerance accepting(const Tolerance& tolerance, const Measurements& measured);

struct AcceptedScene {
  std::string scene;
  Tolerance tolerance;
};

// The text of a tolerance file with an entry for each of these scenes. `text` is what it held until now,
// valid, or empty; entries for other scenes stay as they are and in their order. One entry a line.
std::string with_accepted(const std::string& text, const std::vector<AcceptedScene>& accepted,
                          const std::string& reason);

}  // namespace trace
