// One object missing, or at another place.
#pragma once

#include <optional>
#include <vector>

#include "comparison/diagnosis/diagnosis_edges.hpp"
#include "comparison/diagnosis/diagnosis_regions.hpp"
#include "comparison/diagnosis/diagnosis_signs.hpp"

namespace trace {

// The text names the first and the last pixel of the box: of the worst region for an object that is missing,
// of all that matter for one that is displaced. `outline` is that of all regions, which are not none.
std::optional<Diagnosis> find_object(const std::vector<DifferingRegion>& regions, const EdgeCounts& outline,
                                     const DifferenceSigns& signs, const EdgeSigns& edges);

}  // namespace trace
