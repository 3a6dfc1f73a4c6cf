// Something of the scene is missing or elsewhere: shadows, reflections, highlights, an object.
//
// These causes do not predict the test picture; each only constrains how it may differ:
//   shadows     The test picture is never darker. What was in shadow shows the same surface with more light,
//   so the
//               two colours there have one direction, or the reference is black. Shadow edges that lie on
//               surfaces vanish, and most of what is lit does not change.
//   reflection  Never brighter. Either the edges of mirror images, around and inside them, vanish while the
//   surface that
//               showed them stays; or mirrors differ as a whole: their outlines stay, the edges inside
//               vanish, and the difference is of many colours. Refracted light that is missing looks the
//               same.
//   highlights  Never brighter; the difference fades out, and has the light's colour rather than the
//   surface's. object      Nearly all outlines of the difference vanish (missing), or some vanish and as many
//   appear (displaced),
//               hardly any stays.
// Shares of outlines are those of diagnosis_regions.hpp. The thresholds stand beside their reasons in the
// source; how often each finding is right is in docs/results/diagnosis.md.
#pragma once

#include <optional>

#include "comparison/diagnosis/diagnosis_pair.hpp"

namespace trace {

std::optional<Finding> find_scene(const PicturePair& pair);

}  // namespace trace
