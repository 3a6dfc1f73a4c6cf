// What shadows leave of a light.
#pragma once

#include "shading/options.hpp"
#include "shading/partial_rgb.hpp"
#include "shading/ray_counts.hpp"
#include "shading/surface.hpp"

namespace trace {

// Walks along `ray`, from a surface towards the light, at most `distance`: nothing in the way leaves 1, an
// opaque surface 0, and each passage out of a transmissive one multiplies by the transmittance of the
// distance since the last crossing. Entering costs nothing; by DialectRules::transmission_at_surfaces each
// crossing multiplies by kt instead. No culling. The ray starts at a finite point.
// ShadingOptions::transmissive_shadows has two other rules. Where nothing in the scene lets light through the
// first hit ends it, whichever it is.
PartialRgb shadow_attenuation(const Scene& scene, const SceneTree& tree, const ShadingOptions& options,
                              Ray ray, double distance, RayCounts& counts);

}  // namespace trace
