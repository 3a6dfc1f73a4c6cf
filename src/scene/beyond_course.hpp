// What of a scene the course's language does not have.
#pragma once

#include <string_view>

#include "scene/scene.hpp"

namespace trace {

// The first such thing in the scene ("a spot light"), or nothing. Those who know the course's scenes only
// (src/precision) do not take the others.
std::string_view beyond_course(const Scene& scene);

}  // namespace trace
