// Light that reaches a surface directly: emission, ambient light, and Phong's model for each light.
#pragma once

#include "shading/shadow.hpp"

namespace trace {

// docs/language.md section 7. `toward_surface` is the direction of the ray that sees the surface. An opaque
// surface seen from its back has only emission and ambient light; a transmissive one is shaded with its
// normal turned to the viewer. A surface without a normal has only emission and ambient light too, and a
// light without a direction (none given, or the light in the surface) adds nothing.
Rgb shade_locally(const Scene& scene, const SceneTree& tree, const ShadingOptions& options,
                  const Surface& surface, const Vec3& toward_surface, RayCounts& counts);

}  // namespace trace
