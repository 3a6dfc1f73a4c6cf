// One line that says what kind of mistake a residual looks like, where that is clear.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "comparison/measurements.hpp"
#include "image/raster.hpp"

namespace trace {

struct Diagnosis {
  enum class Kind {
    shifted,           // by whole pixels
    flipped,           // left-right, upside down, or both
    channels_swapped,  // BGR for RGB
    gamma,             // test = reference ^ g
    brightness,        // test = f * reference
    shadows_missing,
    reflection_missing,
    object_missing,  // one connected region, where the test shows what is behind, or black
    object_displaced,
    edges,    // differences along edges only
    blank,    // one colour everywhere
    wrapped,  // bytes that wrap around where the reference is at its limit
    specular_missing
  };
  Kind kind;
  std::string text;  // "shifted by 1 pixel to the right", without a full stop
};

std::string_view name(Diagnosis::Kind kind);  // "object-missing"

// The pictures have the same size and channels and differ. Nothing where no single cause is clear. Boxes in
// the text name their first and last pixel. Nothing is asked of `measured` so far but that it is of these two
// pictures.
std::optional<Diagnosis> diagnose(const Raster& reference, const Raster& test, const Measurements& measured);

}  // namespace trace
