#include "comparison/diagnosis_scene.hpp"

#include <fmt/format.h>

#include "comparison/diagnosis_regions.hpp"
#include "comparison/diagnosis_signs.hpp"

namespace trace {
std::optional<Finding> find_scene(const PicturePair& pair) {
  (void)pair;
  return std::nullopt;
}
}  // namespace trace
