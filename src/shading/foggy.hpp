// What is seen through fog.
#pragma once

#include "scene/fog.hpp"
#include "shading/partial_rgb.hpp"

namespace trace {

// `seen` by a ray from the eye that hit something at `t`, or nothing (length_of_miss), through the fog if
// there is any. Where the fog hides all there is its colour alone.
PartialRgb in_fog(const std::optional<Fog>& fog, const Ray& ray, const PartialRgb& seen, double t);

}  // namespace trace
