// Where a hit is on the pictures of its object, and the normals that pictures make.
#pragma once

#include <optional>

#include "geometry/ray.hpp"
#include "geometry/tangents.hpp"
#include "scene/scene.hpp"

namespace trace {

// A coordinate within [0, 1] as it is, 1 included, any other less its floor; (0, 0) where one is not finite.
Vec2 repeated(const Vec2& uv);

// Where a hit is in the pictures of its object, in [0, 1]^2; (0, 0) on a mesh without texture coordinates. Of
// a mesh with them they are interpolated, and then repeated.
// `p` is the hit's point in the space of the object.
Vec2 texture_coordinates(const Scene& scene, const Object& object, const LocalHit& hit, const Vec3& p);

// Where maps of normals and heights are looked up, and the tangents there in the space of the object. They
// are spread over every object: where there are no texture coordinates, as on a box of unit size, seen along
// the axis that the normal is nearest to, and repeated.
struct NormalPlace {
  Vec2 uv;
  std::optional<Tangents> along;
};
NormalPlace place_of_normals(const Scene& scene, const Object& object, const LocalHit& hit, const Vec3& p);

// The height of a white texel of a bump map above a black one, in lengths of the picture's edges on the
// surface.
inline constexpr double bump_height = 0.1;

// `normal`, which is of unit length in the world, turned by the material's maps of normals and of heights.
// Unchanged where it is not finite, or where the surface has no tangents.
//
// With unit tangents t along u and b along v, in the world, at right angles to the normal n:
//
//   normals: n' = normalize(x t + y b + z n), (x, y, z) = 2 rgb - 1; y is upward in the picture.
//   heights: n' = normalize(n - bump_height (F_u |P_u| grad u + F_v |P_v| grad v)),
//
// which is J. Blinn's formula ("Simulation of Wrinkled Surfaces", SIGGRAPH 1978) for a displacement outward,
// made independent of the surface's size as he proposes. F is the luminance of the map, F_u and F_v its
// differences over a texel either way, at least 1/256; P_u and P_v are the tangents as they come, which need
// not be at right angles to one another, and |P_u| grad u is t where they are. Normals go first.
//
// `direction` is that of the ray that sees the surface. So that its mirror image stays on its side of the
// surface, n' is drawn towards n, halfway each time, until it does.
Vec3 mapped_normal(const Scene& scene, const Object& object, const LocalHit& hit, const Vec3& p,
                   const Vec3& normal, const Vec3& direction);

}  // namespace trace
