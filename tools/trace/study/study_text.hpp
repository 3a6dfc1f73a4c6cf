// A study as text for people.
#pragma once

#include <string>

#include "study/overall.hpp"
#include "study/results.hpp"

namespace trace {

// A table of all settings, what is fastest for some errors, and how good the truth is.
std::string scene_text(const SceneResult& scene);

// A table over all scenes and what follows from it.
std::string overall_text(const Overall& all);

}  // namespace trace
