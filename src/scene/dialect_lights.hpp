// The lights of the dialects: from their attributes, as they are written, to lights.
//
// What every one of them has: `position`, `color`, and the coefficients of attenuation of point lights, each
// 0 where it is not given, so that a light without any does not fade. Angles are in degrees and from the axis
// to the edge of the cone, but `size` of a spot light from edge to edge. docs/language.md has all attributes.
#pragma once

#include <optional>

#include "parser/description.hpp"
#include "parser/diagnostic.hpp"
#include "scene/light.hpp"

namespace trace {

// None, with errors at their places, where an attribute that is needed is missing, or takes another type or
// range of value, or two say the same. Attributes that mean nothing beside the others are warned of, and
// angles that look like radians.
std::optional<Light> make_light(const parser::DialectLight& light, parser::Diagnostics& diagnostics);

}  // namespace trace
