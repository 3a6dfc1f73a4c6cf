// Embree's hierarchy over the same boxes, for comparison.
#pragma once

#include <optional>
#include <span>

#include "geometry/bounds.hpp"

namespace trace::bench {

// The surface-area cost of what Embree's builder of medium quality makes of the boxes, with eight children a
// node and leaves that it fills in blocks of `block` items (at most four items, or eight where blocks are
// larger than one): the surfaces of all nodes, and of all leaves times their blocks, over the root's. None
// where the program is built without Embree.
std::optional<double> embree_surface_area_cost(std::span<const Bounds> boxes, unsigned block);

}  // namespace trace::bench
