// Something of the scene is missing: shadows, reflections, highlights, ambient light, an object.
#pragma once

#include <optional>

#include "comparison/diagnosis_pair.hpp"

namespace trace {

std::optional<Finding> find_scene(const PicturePair& pair);

}  // namespace trace
