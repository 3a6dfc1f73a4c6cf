// Light that reaches a surface directly: emission, ambient light, and Phong's model for each light.
#pragma once

#include "shading/partial_rgb.hpp"
#include "shading/shadow.hpp"

namespace trace {

// docs/language.md section 7. `toward_surface` is the direction of the ray that sees the surface. An opaque
// surface seen from its back has only emission and ambient light; a transmissive one is shaded with its
// normal turned to the viewer. A surface without a normal, or at a point beyond all numbers, has only
// emission and ambient light too, and a light that does not reach it (LightSample) adds nothing. With a
// negative shininess a highlight whose cosine is 0 is infinite, and undefined where its colour is 0.
PartialRgb shade_locally(const Scene& scene, const SceneTree& tree, const ShadingOptions& options,
                         const Surface& surface, const Vec3& toward_surface, RayCounts& counts);

}  // namespace trace
