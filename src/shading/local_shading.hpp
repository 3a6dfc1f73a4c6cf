// Light that reaches a surface directly: emission, ambient light, and Phong's model for each light.
#pragma once

#include "shading/partial_rgb.hpp"
#include "shading/ray_counts.hpp"
#include "shading/surface.hpp"
#include "shading/traced_scene.hpp"

namespace trace {

// docs/language.md section 7. `toward_surface` is the direction of the ray that sees the surface. An opaque
// surface seen from its back has only emission and ambient light; a transmissive one is shaded with its
// normal turned to the viewer. A surface without a normal, or at a point beyond all numbers, has only
// emission and ambient light too, and a light that does not reach it (LightSample) adds nothing. With a
// negative shininess a highlight whose cosine is 0 is infinite, and undefined where its colour is 0.
//
// By DialectRules::two_sided any surface is shaded with its normal turned to the viewer, and light from
// behind it adds nothing; by DialectRules::halfway_highlights highlights are Blinn's.
//
// No shadow ray is cast for a light that adds nothing whatever the shadow is: RayCounts::work tells of which
// there were how many. With ShadingOptions::model_everything they are cast.
PartialRgb shade_locally(const TracedScene& world, const Surface& surface, const Vec3& toward_surface,
                         RayCounts& counts);

// Whether the power of a highlight is to be taken: it is finite below an exponent of a million, for its base
// is at most 1 and a few roundings, and 0 times it is 0.
inline bool needs_highlight(const Material& material, double shininess) {
  return !(is_zero(material.specular) && shininess >= 0 && shininess <= 1e6);
}

}  // namespace trace
