// Rays at one shape, ordinary ones and those at the places where formulas have their special cases.
#pragma once

#include <optional>

#include "tests/support/scene_random.hpp"

namespace trace::test {

enum class RayKind {
  towards,       // from somewhere outside to somewhere inside its bounds
  past,          // from somewhere in any direction
  inside,        // from within
  leaving,       // from its surface, with the bounds on errors that shading gives such rays
  on_grid,       // from a coarse grid along axes and diagonals, with zeros and negative zeros
  far_away,      // from a million units off
  tiny,          // from a millionth above or below the surface
  tangent,       // along the surface
  through_edge,  // through edges, corners, rims and tips
  along_edge,    // from one such place to another
};
inline constexpr RayKind all_ray_kinds[] = {
    RayKind::towards,  RayKind::past, RayKind::inside,  RayKind::leaving,      RayKind::on_grid,
    RayKind::far_away, RayKind::tiny, RayKind::tangent, RayKind::through_edge, RayKind::along_edge};

// `shape` is not a mesh.
Ray ray_at(const Shape& shape, RayKind kind, Random& random);

// Where a ray meets it.
std::optional<LocalHit> meet(const Shape& shape, const Ray& ray);

}  // namespace trace::test
