// The fog that a scene describes.
#pragma once

#include <optional>

#include "parser/description.hpp"
#include "parser/diagnostic.hpp"
#include "scene/fog.hpp"

namespace trace {

// None, with an error at its place, where an attribute is missing or out of range, or two contradict.
std::optional<Fog> make_fog(const parser::Fog& fog, parser::Diagnostics& diagnostics);

}  // namespace trace
